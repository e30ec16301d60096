import { spawn } from 'node:child_process'
import { fileURLToPath } from 'node:url'

/** Root of the repository. All commands run in this folder. */
export const ROOT = fileURLToPath(new URL('../../', import.meta.url))

export function say(text) {
  console.info(`furrow: ${text}`)
}

/**
 * Runs a program and waits for its end.
 *
 * @param {string[]} words program and arguments.
 * @param {{ quiet?: boolean, env?: NodeJS.ProcessEnv, input?: 'ignore' | 'inherit', started?: (id: number) => void }}
 *   [options] `quiet`: print the output only if the program fails. `input`: standard input. `started`: called with the
 *   process id.
 * @returns {Promise<number>} exit code. It is 1 if the program was killed or could not be started.
 */
export function run([program, ...parameters], options = {}) {
  const { quiet = false, env = process.env, input = 'ignore', started } = options
  return new Promise((done) => {
    const output = []
    // On Windows, npm and npx are scripts that need a shell.
    const shell = process.platform === 'win32'
    const stdio = [input, quiet ? 'pipe' : 'inherit', quiet ? 'pipe' : 'inherit']
    const child = spawn(program, parameters, { cwd: ROOT, env, shell, stdio })
    if (child.pid) started?.(child.pid)
    for (const stream of [child.stdout, child.stderr]) stream?.on('data', (data) => output.push(data))
    const end = (code, message = '') => {
      if (code !== 0) process.stderr.write(Buffer.concat(output).toString() + message)
      done(code ?? 1)
    }
    child.on('error', (error) => end(1, `${error.message}\n`))
    child.on('close', (code) => end(code))
  })
}

/** Runs a program like `run`, but throws if it fails. */
export async function must(words, options) {
  const code = await run(words, options)
  if (code !== 0) throw new Failure(`"${words.join(' ')}" failed with exit code ${code}`)
}

/** Expected error of a script. It is printed as one line, without a stack. */
export class Failure extends Error {}

/** Runs the main function of a script. Prints an error that it throws, and sets exit code 1. */
export async function main(work) {
  try {
    await work()
  } catch (error) {
    const known = error instanceof Failure || error.name === 'FurrowError'
    const isUsage = error.code?.startsWith('ERR_PARSE_ARGS')
    console.error(known || isUsage ? `furrow: ${error.message}` : error)
    process.exitCode = 1
  }
}
