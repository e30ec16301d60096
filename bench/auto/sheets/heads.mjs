import { execFile } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { BEFORE, SCAN } from '../../../scripts/figures/faces.mjs'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { must, ROOT, say } from '../../../scripts/lib/run.mjs'
import { setUpSampleHeads } from '../sample-heads.mjs'

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
 * Generates wrinkles for heads. Skips files that the same generator has written.
 *
 * @param folder folder of the results.
 * @returns a function that returns the path of a head with wrinkles.
 */
export async function wrinkledHeads(heads, ages, folder) {
  const { runConcurrently } = await importSource('packages/cli/src/batch/run-concurrently.ts')
  mkdirSync(folder, { recursive: true })
  const stamps = Object.fromEntries(Object.entries(VERSIONS).map(([name, root]) => [name, stampOf(root)]))
  const pathOf = (version, { name }, age) => join(folder, `${name}-${version}-${age}-${stamps[version]}.glb`)
  const wanted = Object.keys(VERSIONS).flatMap((version) =>
    heads.flatMap((head) => ages.map((age) => ({ version, head, age, file: pathOf(version, head, age) }))),
  )
  const missing = wanted.filter(({ file }) => !existsSync(file))
  await runConcurrently(missing, availableParallelism(), async ({ version, head, age, file }, i) => {
    const isOld = (name) => name.startsWith(`${head.name}-${version}-${age}-`)
    for (const name of readdirSync(folder).filter(isOld)) rmSync(join(folder, name))
    const command = join(VERSIONS[version], 'packages/cli/dist/main.js')
    const options = ['-o', file, '--age', `${age}`, '--replace']
    await promisify(execFile)(process.execPath, [command, 'auto', head.file, ...options])
    say(`wrinkles ${i + 1}/${missing.length}: ${head.name}, ${version}, ${age} years`)
  })
  return pathOf
}

/** Returns a hash of the built generator of a checkout. */
function stampOf(root) {
  const hash = createHash('sha256')
  for (const part of ['furrow', 'files']) {
    const built = join(root, 'packages/cli/dist', part)
    const names = readdirSync(built, { recursive: true }).filter((name) => name.endsWith('.js'))
    for (const name of names.sort()) hash.update(readFileSync(join(built, name)))
  }
  return hash.digest('hex').slice(0, 8)
}
