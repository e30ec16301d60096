import { REVISION } from 'three'
import { REVISION as NODES_REVISION } from 'three/webgpu'
import { expect, inject, it } from 'vitest'
import { TESTED_THREE } from '../../packages/furrow/src/three/three-version.ts'

it('tests the release of three.js that the project names', () => {
  const release = String(TESTED_THREE[inject('threeRelease') ?? 'newest'])
  expect([REVISION, NODES_REVISION]).toEqual([release, release])
})
