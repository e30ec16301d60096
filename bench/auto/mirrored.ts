import { readFile, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { Document, Logger, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { accessorsOf } from '../../test/accessors.ts'
import { decimate, foldUvs } from '../../test/heads.ts'

const TRIANGLES = [742, 20_000]
/** Ball radius, metres. */
const RADIUS = 0.1
/** Number of blendshapes of the ball. Each compresses it in a different direction. */
const SQUEEZES = 8
/** Fraction by which a blendshape shortens the ball. */
const SQUEEZE = 0.3

const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS)

/**
 * Writes a simplified face and a featureless ball, each with 742 and with 20,000 triangles. The left and right halves of each mesh share texture
 * coordinates.
 *
 * @param face path of a glTF file with a mesh named `skin`.
 * @param folder folder for the files.
 * @returns paths of the files.
 */
export async function writeMirrored(face: string, folder: string): Promise<string[]> {
  const bytes = await readFile(face)
  const write = async (name: string, document: Document) => {
    const path = join(folder, name)
    await writeFile(path, await io.writeBinary(document))
    return path
  }
  const paths: string[] = []
  for (const triangles of TRIANGLES) {
    const head = await io.readBinary(bytes)
    await decimate(head, triangles / trianglesOf(head))
    foldUvs(head)
    paths.push(await write(`mirrored-face-${triangles}.glb`, head))
    const ball = createBall(triangles)
    foldUvs(ball)
    paths.push(await write(`mirrored-ball-${triangles}.glb`, ball))
  }
  return paths
}

function trianglesOf(document: Document): number {
  const meshes = document.getRoot().listMeshes()
  const [skin] = meshes.find((mesh) => mesh.getName() === 'skin')!.listPrimitives()
  return skin!.getIndices()!.getCount() / 3
}

function createBall(triangles: number): Document {
  const side = Math.round(Math.sqrt(triangles / 2))
  const [positions, uvs, indices]: number[][] = [[], [], []]
  for (let row = 0; row <= side; row++) {
    for (let column = 0; column <= side; column++) {
      const [turn, tilt] = [(2 * Math.PI * column) / side, Math.PI * (0.02 + (0.96 * row) / side)]
      positions.push(
        RADIUS * Math.sin(tilt) * Math.sin(turn),
        RADIUS * Math.cos(tilt),
        -RADIUS * Math.sin(tilt) * Math.cos(turn),
      )
      uvs.push(column / side, row / side)
      const first = row * (side + 1) + column
      const below = first + side + 1
      if (row < side && column < side) indices.push(first, below + 1, below, first, first + 1, below + 1)
    }
  }
  const document = new Document()
  const accessor = accessorsOf(document)
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
    .setAttribute(
      'NORMAL',
      accessor(
        'VEC3',
        Float32Array.from(positions, (value) => value / RADIUS),
      ),
    )
    .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs)))
    .setIndices(accessor('SCALAR', Uint32Array.from(indices)))
    .setMaterial(document.createMaterial('ball'))
  const names = Array.from({ length: SQUEEZES }, (_, i) => `squeeze${i}`)
  for (const [i, name] of names.entries())
    primitive.addTarget(
      document
        .createPrimitiveTarget(name)
        .setAttribute('POSITION', accessor('VEC3', squeeze(positions, (Math.PI * i) / SQUEEZES))),
    )
  const mesh = document.createMesh('ball').addPrimitive(primitive).setExtras({ targetNames: names })
  document.createScene().addChild(document.createNode('ball').setMesh(mesh))
  return document
}

/** Returns the offset of each vertex for a blendshape that compresses the ball along a direction in the xy plane. `angle` is in radians. */
function squeeze(positions: readonly number[], angle: number): Float32Array<ArrayBuffer> {
  const [x, y] = [Math.cos(angle), Math.sin(angle)]
  return Float32Array.from(positions, (_, i) => {
    const first = i - (i % 3)
    const along = positions[first]! * x + positions[first + 1]! * y
    return -SQUEEZE * along * [x, y, 0][i % 3]!
  })
}
