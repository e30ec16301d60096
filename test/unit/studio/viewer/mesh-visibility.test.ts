import { signal } from '@preact/signals'
import { Mesh } from 'three'
import { expect, it } from 'vitest'
import { MeshVisibility } from '../../../../studio/src/viewer/mesh-visibility.ts'
import type { Viewer } from '../../../../studio/src/viewer/viewer.ts'

const isDrawn = ({ layers }: Mesh) => layers.isEnabled(0)

it('hides the meshes of a place to which the user returns, and shows the others', () => {
  const meshes = [new Mesh(), new Mesh(), new Mesh()]
  const viewer = { meshes } as unknown as Viewer
  const visibility = new MeshVisibility(signal(viewer), () => {})
  visibility.toggle(meshes[0])
  // The file may have changed, so that it has fewer meshes than before.
  visibility.restore(viewer, [2, 7])
  expect(meshes.map(isDrawn)).toEqual([true, true, false])
})
