import type { Document, Mesh, Node } from '@gltf-transform/core'
import { simplify, weld } from '@gltf-transform/functions'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import { noName, swapSide } from './rigs/naming-schemes.ts'

/** Lists a document's meshes with blendshapes, and their names. */
function blendMeshes(document: Document): { mesh: Mesh; names: string[] }[] {
  return document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => {
      const names = mesh.getExtras().targetNames as string[] | undefined
      return names ? [{ mesh, names }] : []
    })
}

/** Renames blendshapes. Equal names on several meshes stay equal. */
export function renameTargets(document: Document, rename: (name: string, index: number) => string): void {
  const all = [...new Set(blendMeshes(document).flatMap(({ names }) => names))]
  for (const { mesh, names } of blendMeshes(document)) {
    const targetNames = names.map((name) => rename(name, all.indexOf(name)))
    mesh.setExtras({ ...mesh.getExtras(), targetNames })
    for (const primitive of mesh.listPrimitives())
      for (const [i, target] of primitive.listTargets().entries()) target.setName(targetNames[i]!)
  }
}

/** Replaces names by `target_0`, `target_1` ... */
export function removeNames(document: Document): void {
  renameTargets(document, (_, index) => noName(index))
}

/** Swaps left and right in names, as if the file had its sides swapped. */
export function swapSides(document: Document): void {
  renameTargets(document, swapSide)
}

/** Removes blendshapes. */
export function keepTargets(document: Document, isKept: (name: string) => boolean): void {
  for (const { mesh, names } of blendMeshes(document)) {
    const kept = names.filter(isKept)
    for (const primitive of mesh.listPrimitives()) {
      const targets = primitive.listTargets()
      for (const [i, name] of names.entries()) if (!isKept(name)) primitive.removeTarget(targets[i]!)
    }
    mesh.setWeights(kept.map(() => 0)).setExtras({ ...mesh.getExtras(), targetNames: kept })
  }
}

/** Puts everything under one node that is mirrored, turned or scaled. */
export function placeScene(
  document: Document,
  { scale, rotation }: { scale?: [number, number, number]; rotation?: [number, number, number, number] },
): Node {
  const scene = document.getRoot().listScenes()[0]!
  const node = document.createNode('placed')
  for (const child of scene.listChildren()) node.addChild(child)
  scene.addChild(node)
  if (scale) node.setScale(scale)
  if (rotation) node.setRotation(rotation)
  return node
}

/** Removes meshes by name, such as the eyes. */
export function removeMeshes(document: Document, names: RegExp): void {
  for (const mesh of document.getRoot().listMeshes()) if (names.test(mesh.getName())) mesh.dispose()
}

/** Folds the right half's UVs onto the left half's, so that both use the same texels. */
export function foldUvs(document: Document): void {
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())
  for (const uvs of new Set(primitives.map((primitive) => primitive.getAttribute('TEXCOORD_0')))) {
    for (let i = 0; uvs && i < uvs.getCount(); i++) {
      const [u, v] = uvs.getElement(i, [0, 0])
      uvs.setElement(i, [0.5 + Math.abs(u - 0.5), v])
    }
  }
}

/** Reduces all meshes and their blendshapes to about a fraction of their vertices. */
export async function decimate(document: Document, ratio: number): Promise<void> {
  await MeshoptSimplifier.ready
  await document.transform(weld(), simplify({ simplifier: MeshoptSimplifier, ratio, error: 1 }))
}
