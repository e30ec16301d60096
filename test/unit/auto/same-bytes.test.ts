import { execFile, execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { expect, test } from 'vitest'
import { bundle } from '../../../scripts/lib/bundle.mjs'
import { smallHead } from '../../small-head.ts'

const FACE = 'faces/human.glb'
const VERSION = 'process.version + " on " + process.arch'
/** An emulated processor takes minutes. */
const PATIENCE = 1_800_000

/**
 * Command of the Node to compare with, as words. By default it is the Node that runs npm: `npm run test:lts` runs the tests on a newer Node.
 * `FURROW_OTHER_NODE` can name another command, such as an emulator with a Node for another processor.
 */
const OTHER = (process.env.FURROW_OTHER_NODE ?? process.env.npm_node_execpath ?? process.execPath).split(' ')
const [command = '', ...words] = OTHER

const [own, other] = [
  execFileSync(process.execPath, ['-p', VERSION], { encoding: 'utf8' }).trim(),
  execFileSync(command, [...words, '-p', VERSION], { encoding: 'utf8' }).trim(),
]

test.skipIf(own === other)(
  `each step of automatic wrinkles gives the same bits in Node ${own} and ${other}`,
  async () => {
    const folder = mkdtempSync(join(tmpdir(), 'furrow-digests-'))
    try {
      const small = join(folder, 'small-head.glb')
      writeFileSync(small, await smallHead(FACE))
      const script = await bundle('test/print-digests.ts')
      const digestsIn = async (node: string, ...options: string[]) =>
        JSON.parse((await promisify(execFile)(node, [...options, script, FACE, small])).stdout)
      const [here, there] = await Promise.all([digestsIn(process.execPath), digestsIn(command, ...words)])
      expect(Object.keys(here)).toHaveLength(2)
      expect(there).toEqual(here)
    } finally {
      rmSync(folder, { recursive: true })
    }
  },
  PATIENCE,
)
