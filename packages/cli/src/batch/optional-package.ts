import { FurrowError } from 'furrow'

/** Loads an optional peer dependency. Throws an error with install instructions if it is missing. */
export async function optionalPackage<T>(load: () => Promise<T>, names: string, use: string): Promise<T> {
  try {
    return await load()
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'ERR_MODULE_NOT_FOUND') throw error
    throw new FurrowError(
      {
        code: 'unsupported',
        who: 'furrow',
        problem: `${use} needs ${names}, which is not installed`,
        remedy: `run npm install ${names} beside furrow-cli, or npx --yes ${['furrow-cli', ...names.split(' ')].map((name) => `-p ${name}`).join(' ')} furrow`,
      },
      { cause: error },
    )
  }
}
