import { existsSync, mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { BEFORE, SCAN } from '../../../scripts/figures/faces.mjs'
import { must, ROOT, say } from '../../../scripts/lib/run.mjs'
import { setUpSampleHeads } from '../sample-heads.mjs'
import { wrinkleFiles } from './wrinkle-files.mjs'

/** Seeds of random heads. */
const SAMPLES = { realistic: [41, 42, 43, 44, 45], stylised: [41, 42, 43] }

/** Checkouts whose wrinkles are drawn, by the name in the files. */
export const VERSIONS = { ...(BEFORE && { before: BEFORE }), after: ROOT }

/**
 * Returns the heads of the sheets. The scan is left out if it is missing.
 *
 * @param folder folder of the random heads, which are built once.
 */
export async function sheetHeads(folder) {
  const heads = ['human', 'human-2'].map((name) => ({ name, file: join(ROOT, `faces/${name}.glb`) }))
  if (existsSync(SCAN)) heads.push({ name: 'scan', file: SCAN })
  mkdirSync(folder, { recursive: true })
  let commandFor
  for (const [family, seeds] of Object.entries(SAMPLES)) {
    for (const seed of seeds) {
      const name = `${family}-${seed}`
      const file = join(folder, `${name}.glb`)
      heads.push({ name, file })
      if (existsSync(file)) continue
      commandFor ??= await setUpSampleHeads()
      say(`building ${name}`)
      await must(commandFor(family, seed, folder))
    }
  }
  return heads
}

/**
 * Generates wrinkles for heads with each version.
 *
 * @param folder folder of the results.
 * @returns a function that returns the path of a head with wrinkles.
 */
export async function wrinkledHeads(heads, ages, folder) {
  const nameOf = (version, { name }, age) => `${name}-${version}-${age}`
  const jobs = Object.entries(VERSIONS).flatMap(([version, root]) =>
    heads.flatMap((head) =>
      ages.map((age) => {
        const options = ['--age', `${age}`, '--replace']
        return { name: nameOf(version, head, age), input: head.file, root, options }
      }),
    ),
  )
  const paths = await wrinkleFiles(jobs, folder)
  return (version, head, age) => paths.get(nameOf(version, head, age))
}
