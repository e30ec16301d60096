import { REVISION } from 'three'
import { REVISION as NODES_REVISION } from 'three/webgpu'
import { expect, inject, it } from 'vitest'
import { NEWEST_THREE, OLDEST_THREE } from '../../packages/furrow/src/three/three-version.ts'

it('tests run on the release of three.js named by the project', () => {
  const isOldest = inject('threeRelease') === 'oldest'
  const release = String(isOldest ? OLDEST_THREE['furrow/webgpu'] : NEWEST_THREE)
  expect([REVISION, NODES_REVISION]).toEqual([release, release])
})
