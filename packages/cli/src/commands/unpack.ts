import { readdir, rename, rm, rmdir, stat } from 'node:fs/promises'
import { join, resolve } from 'node:path'
import { Command } from 'commander'
import { FurrowError } from 'furrow'
import { firstLine, type Output, writeAll } from '../images.ts'
import { withBar } from '../progress.ts'
import { encodeGlb } from '../wrinkles/glb-file.ts'
import { stripWrinkles } from '../wrinkles/strip.ts'
import { unpackWrinkles } from '../wrinkles/unpack.ts'
import { readWrinkledFile } from '../wrinkles/wrinkled-file.ts'

const WHO = 'furrow unpack'

interface Options {
  output: string
  material?: string
  whiteIsVisible?: boolean
  json?: boolean
}

/** `furrow unpack`: the reverse of `furrow pack`. */
export const unpackCommand = new Command('unpack')
  .description('take the wrinkles out of a face: one .glb becomes a folder of images')
  .argument('<face>', 'a face with wrinkles (.glb)')
  .requiredOption('-o, --output <folder>', 'the folder, which must be new or empty')
  .option('--material <name>', 'the material that has them (default: the only one)')
  .option('--white-is-visible', 'paint areas white where wrinkles show (default: the other way round)')
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
The folder holds face.glb without wrinkles, wrinkles.json, layers/ and areas/; furrow pack makes the file again.

Example:
  $ furrow unpack wrinkled.glb -o my-face`,
  )
  .action(unpack)

async function unpack(path: string, options: Options): Promise<void> {
  const { output, material, whiteIsVisible = false, json } = options
  await checkEmpty(output)
  const file = await readWrinkledFile(path, WHO, material)
  const outputs = await withBar('unpack', (progress) => unpackWrinkles(file, whiteIsVisible, WHO, progress))
  const left = stripWrinkles(file.glb, file.material, WHO)
  outputs.push({ path: 'face.glb', bytes: encodeGlb(file.glb) })
  await writeFolder(output, outputs)
  for (const warning of file.glb.warnings) console.error(warning)
  if (left > 0) {
    console.error(`${WHO}: ${left} textures stay in face.glb unused, because others follow them in the file`)
  }
  const files = outputs.map((item) => item.path).sort()
  const { layers, areas } = file.maps
  const text = json
    ? JSON.stringify({ folder: output, files })
    : `${output}: ${files.length} files; layers: ${layers.length}, areas: ${areas.length}`
  process.stdout.write(`${text}\n`)
}

async function checkEmpty(folder: string): Promise<void> {
  const found = await stat(folder).catch(() => undefined)
  if (!found) return
  if (found.isDirectory() && (await readdir(folder)).length === 0) return
  throw new FurrowError({
    who: WHO,
    what: `${folder} is ${found.isDirectory() ? 'not empty' : 'a file'}`,
    limit: 'a new or an empty folder',
    remedy: 'name another one; nothing is overwritten',
  })
}

/** The folder appears whole or not at all: it is filled under another name beside its place. */
async function writeFolder(folder: string, outputs: readonly Output[]): Promise<void> {
  const place = resolve(folder)
  const aside = `${place}.${process.pid}.tmp`
  try {
    await writeAll(
      outputs.map(({ path, bytes }) => ({ path: join(aside, path), bytes })),
      WHO,
    )
    // Goes only if it is still empty; otherwise the renaming fails, and nothing of the user's is lost.
    await rmdir(place).catch(() => {})
    await rename(aside, place)
  } catch (error) {
    await rm(aside, { recursive: true, force: true }).catch(() => {})
    if (error instanceof FurrowError) throw error
    throw new FurrowError({
      who: WHO,
      what: `cannot write ${folder} (${firstLine(error)})`,
      remedy: 'choose a folder you may write to',
    })
  }
}
