import { FaceScores } from 'furrow/three'
import { Group } from 'three'
import { afterEach, expect, it, vi } from 'vitest'
import { blendMesh } from '../../blend-mesh.ts'

const scoreList = (scores: Record<string, number>) =>
  Object.entries(scores).map(([categoryName, score]) => ({ categoryName, score }))

afterEach(() => vi.restoreAllMocks())

it('moves each mesh of the face, with its names in any spelling, and keeps other blendshapes', () => {
  const warn = vi.spyOn(console, 'warn')
  const skin = blendMesh('browDown_L', 'browInnerUp_L', 'browInnerUp_R', 'tongueOut')
  const lashes = blendMesh('Fcl.browDownLeft')
  skin.morphTargetInfluences![3] = 0.3
  const scores = new FaceScores(new Group().add(skin, lashes))
  scores.set(scoreList({ _neutral: 0.9, browDownLeft: 0.7, browInnerUp: 0.4 }))
  expect(skin.morphTargetInfluences).toEqual([0.7, 0.4, 0.4, 0.3])
  expect(lashes.morphTargetInfluences).toEqual([0.7])
  // The next scores have another order and fewer names, and one score is invalid.
  scores.set(scoreList({ browInnerUp: Number.NaN, browDownLeft: 0.1 }))
  expect(skin.morphTargetInfluences).toEqual([0.1, 0, 0, 0.3])
  expect(warn).not.toHaveBeenCalled()
})

it('logs one warning for names that the face lacks', () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
  const face = blendMesh('jawOpen')
  const scores = new FaceScores(face)
  for (let i = 0; i < 3; i++) scores.set(scoreList({ _neutral: 1, trunkUp: 1, jawOpen: 0.5 }))
  expect(face.morphTargetInfluences).toEqual([0.5])
  expect(warn).toHaveBeenCalledTimes(1)
  expect(warn.mock.calls[0][0]).toContain('got "trunkUp"')
})

it('refuses a face without blendshapes', () => {
  expect(() => new FaceScores(new Group()).set(scoreList({ jawOpen: 1 }))).toThrow(
    /FaceScores: no morph targets/,
  )
})
