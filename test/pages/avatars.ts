/** Writes a folder of avatars that are similar to those of users. All are made from a shipped face. */

import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { type Document, Logger, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { draco, prune } from '@gltf-transform/functions'
import draco3d from 'draco3d'
import sharp from 'sharp'
import { turnScene } from '../avatar.ts'
import { asVrm0 } from '../vrm.ts'

const HUMAN = fileURLToPath(new URL('../../faces/human.glb', import.meta.url))

export const io = new NodeIO()
  .setLogger(new Logger(Logger.Verbosity.SILENT))
  .registerExtensions(ALL_EXTENSIONS)
  .registerDependencies({ 'draco3d.encoder': await draco3d.createEncoderModule() })

/** Reads the shipped face. glTF-Transform drops its wrinkles, because the extension is not registered. */
export async function plainHuman(): Promise<Document> {
  const document = await io.read(HUMAN)
  return document.transform(prune({ keepLeaves: true, keepAttributes: true, keepExtras: true }))
}

/** Writes `plain.glb`, the shipped face without wrinkles. */
export async function writePlain(folder: string): Promise<void> {
  writeFileSync(join(folder, 'plain.glb'), await io.writeBinary(await plainHuman()))
}

/** Writes no avatar, for tests that use the faces of the studio. */
export async function writeNone(): Promise<void> {}

/**
 * Writes `plain.glb`, `draco.glb`, `turned.vrm`, `broken.glb` and `model.fbx`. Also writes `separate/`, a `.gltf` with a folder of
 * textures, and `wrinkles/`, a wrinkle set with `face.glb`, one layer and one area.
 */
export async function writeAvatars(folder: string): Promise<void> {
  const write = (path: string, bytes: Uint8Array | string) => writeFileSync(join(folder, path), bytes)
  for (const path of ['separate/my textures', 'wrinkles/layers/up', 'wrinkles/areas']) {
    mkdirSync(join(folder, path), { recursive: true })
  }
  const plain = await io.writeBinary(await plainHuman())
  write('plain.glb', plain)
  write('broken.glb', plain.subarray(0, plain.length / 2))
  write('model.fbx', 'Kaydara FBX Binary  ')
  write('draco.glb', await io.writeBinary(await (await plainHuman()).transform(draco())))

  const turned = await plainHuman()
  turnScene(turned, 180)
  write('turned.vrm', asVrm0(await io.writeBinary(turned), undefined, addYawn))

  const { json, resources } = await io.writeJSON(await plainHuman(), { basename: 'avatar' })
  for (const image of json.images ?? []) {
    write(`separate/my textures/${image.uri}`, resources[image.uri!])
    image.uri = `my%20textures/${image.uri}`
  }
  write('separate/avatar.bin', resources['avatar.bin'])
  write('separate/avatar.gltf', JSON.stringify(json))

  write('wrinkles/face.glb', plain)
  write('wrinkles/layers/up/normal.png', await ripples())
  const black = { create: { width: 32, height: 32, channels: 3, background: '#000' } } as const
  write('wrinkles/areas/everywhere.png', await sharp(black).png().toBuffer())
}

/** Adds a custom expression to a VRM 0. */
const addYawn: Parameters<typeof asVrm0>[2] = ({ meshes, extensions: { VRM } }) => {
  const targets: (string[] | undefined)[] = meshes.map(({ extras }: MeshJson) => extras?.targetNames)
  const mesh = targets.findIndex((names) => names?.includes('jawOpen'))
  const binds = [{ mesh, index: targets[mesh]!.indexOf('jawOpen'), weight: 75 }]
  VRM.blendShapeMaster.blendShapeGroups.push({ name: 'Yawn', presetName: 'unknown', binds })
}

interface MeshJson {
  extras?: { targetNames?: string[] }
}

/** Makes a normal map of horizontal waves. */
function ripples(): Promise<Buffer> {
  const size = 256
  const data = Buffer.alloc(3 * size * size)
  for (let i = 0; i < size * size; i++) {
    const slope = 0.6 * Math.sin((2 * Math.PI * Math.floor(i / size)) / 16)
    data.set([128, 127.5 + 127.5 * slope, 127.5 + 127.5 * Math.sqrt(1 - slope ** 2)].map(Math.round), 3 * i)
  }
  return sharp(data, { raw: { width: size, height: size, channels: 3 } })
    .png()
    .toBuffer()
}
