import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import type { AutoCharacterOptions } from 'furrow/auto'
import { WrinkleLoaderPlugin } from 'furrow/three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { vi } from 'vitest'
import { editGlb } from '../../glb.ts'
import { FakeWorker } from './fake-worker.ts'
import { fakeBrowser } from './node-loader.ts'

/** Reads a model that ships, without its wrinkles. */
export function plainModel(
  name: string,
  edit: Parameters<typeof editGlb>[1] = () => {},
): Uint8Array<ArrayBuffer> {
  const path = fileURLToPath(new URL(`../../../faces/${name}.glb`, import.meta.url))
  return editGlb(readFileSync(path), (json) => {
    for (const { extensions } of json.materials) delete extensions?.FURROW_wrinkle_maps
    edit(json)
  })
}

/** Loads a file with the option `auto`. */
export async function loadAuto(bytes: Uint8Array<ArrayBuffer>, auto: AutoCharacterOptions): Promise<GLTF> {
  fakeBrowser()
  vi.stubGlobal('Worker', FakeWorker)
  const loader = new GLTFLoader().register((parser) => new WrinkleLoaderPlugin(parser, { auto }))
  return loader.parseAsync(bytes.buffer, '')
}
