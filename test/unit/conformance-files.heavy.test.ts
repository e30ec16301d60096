import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import { filesOf } from '../../conformance/src/make.ts'
import { SAMPLES } from '../../conformance/src/samples.ts'

const FOLDER = fileURLToPath(new URL('../../conformance/files', import.meta.url))

// Files of other programs differ with their versions.
const own = SAMPLES.filter(({ file }) => file.storage === undefined)

it.each(own)('$name is what npm run conformance makes', async (sample) => {
  for (const [name, bytes] of await filesOf(sample)) {
    expect(Buffer.compare(readFileSync(join(FOLDER, name)), bytes), name).toBe(0)
  }
})
