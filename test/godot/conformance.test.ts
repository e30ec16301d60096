import { describe, expect, it } from 'vitest'
import { SAMPLES as CASES } from '../../conformance/src/samples.ts'
import { addressOf } from '../gpu/conformance/samples.ts'
import { checkSample, type OpenedSample, testSamples } from '../gpu/conformance/suite.ts'
import { bytesOf } from './files.ts'
import { godot } from './harness.ts'
import { openSample } from './runner.ts'

/** Samples that Godot cannot read, with Godot's own message. */
const UNREADABLE: Readonly<Record<string, string>> = {
  quantized: "required extension 'KHR_mesh_quantization' is not supported",
  meshopt: "required extension 'EXT_meshopt_compression' is not supported",
  draco: "required extension 'KHR_draco_mesh_compression' is not supported",
}

const harness = godot()
const load = async (name: string) => (await fetch(addressOf(name))).arrayBuffer()

describe('conformance of Godot', () => {
  testSamples(async (name) => {
    if (!(name in UNREADABLE)) return openSample(harness, await load(name))
    const scene = await harness.open(await load(name))
    const faces = 'error' in scene ? 0 : scene.faces
    return { isWrinkled: faces > 0, dispose: () => {} } as OpenedSample
  }, Object.keys(UNREADABLE))
})

describe.each(Object.entries(UNREADABLE))('%s', (name, message) => {
  it('is not readable by Godot itself', async () => {
    await harness.open(await load(name))
    expect(harness.messages.join('\n')).toContain(message)
  })

  it('passes as an uncompressed copy', async () => {
    const { file } = CASES.find((sample) => sample.name === name)!
    await checkSample(await openSample(harness, bytesOf({ ...file, storage: undefined })), name)
  })
})
