import { signal } from '@preact/signals'
import { Group } from 'three'
import { beforeEach, expect, it } from 'vitest'
import { readLiveLinkFace } from '../../../studio/src/capture/live-link-face.ts'
import { motionOf } from '../../../studio/src/document/take.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { TakeEditor } from '../../../studio/src/session/take-editor.ts'
import { ClipPlayer } from '../../../studio/src/viewer/pose/clip-player.ts'
import { targetDials } from '../../../studio/src/viewer/pose/dials.ts'
import { blendMesh } from '../../blend-mesh.ts'
import { frozen, sampleDocument } from './sample-document.ts'

const { takes: _, ...document } = sampleDocument()
const motionOfJaw = () => motionOf([0, 1], [['jawOpen', [0, 1]]])

let session: Session
let player: ClipPlayer
let editor: TakeEditor
let saved: { file: Blob; name: string } | null
let errors: string[]

beforeEach(() => {
  session = new Session()
  session.open(frozen(document))
  const root = new Group().add(blendMesh('jawOpen', 'browInnerUp'))
  const viewer = { avatar: { root }, targets: targetDials(root), move: (change: () => void) => change() }
  const shown = signal(viewer as never)
  player = new ClipPlayer({ viewer: shown, begin: () => {}, onPose: () => {} })
  player.open(root, [])
  ;[saved, errors] = [null, []]
  editor = new TakeEditor({
    session,
    player,
    viewer: shown,
    ready: async () => {},
    saveFile: (file, name) => {
      saved = { file, name }
    },
    attempt: (task) => {
      try {
        task()
      } catch (error) {
        errors.push((error as Error).message)
      }
    },
  })
})

/** Records a take and waits until it is added. */
async function record() {
  editor.add(motionOfJaw())
  await Promise.resolve()
}

it('each action is one undo step, and the player follows', async () => {
  await record()
  await record()
  expect(player.takes.value.map(({ name }) => name)).toEqual(['Take 1', 'Take 2'])
  expect(editor.chosen.value?.name).toBe('Take 2')
  editor.rename('Take 2', 'Smile')
  editor.trim('Smile', [0.25, 0.5])
  expect(player.clip.value).toMatchObject({ name: 'Smile', range: [0.25, 0.5] })
  editor.remove('Smile')
  expect(player.takes.value.map(({ name }) => name)).toEqual(['Take 1'])
  const labels: (string | undefined)[] = []
  for (; session.undoLabel.value; session.undo()) labels.push(session.undoLabel.value)
  expect(labels).toEqual(['Delete a take', 'Trim a take', 'Rename a take', 'Record a take', 'Record a take'])
  expect(player.takes.value).toEqual([])
  session.redo()
  expect(player.takes.value.map(({ name }) => name)).toEqual(['Take 1'])
})

it('in and out points are set at the time of the player', async () => {
  await record()
  player.scrub(0.5)
  editor.trimAtTime('in')
  player.scrub(0.75)
  editor.trimAtTime('out')
  expect(editor.chosen.value?.range).toEqual([0.5, 0.75])
  player.scrub(0.25)
  editor.trimAtTime('out')
  expect(editor.chosen.value?.range).toEqual([0.25, 0.25 + 1 / 60])
})

it('an invalid name is refused, and the take keeps its name', async () => {
  await record()
  editor.rename('Take 1', '')
  expect(errors).toHaveLength(1)
  expect(editor.chosen.value?.name).toBe('Take 1')
})

it('a take is saved as a file that can be opened as a take', async () => {
  await record()
  editor.rename('Take 1', 'a/b')
  await editor.save(editor.chosen.value!)
  expect(saved?.name).toBe('a_b.csv')
  await editor.open(await readLiveLinkFace(new File([saved!.file], saved!.name)))
  expect(editor.chosen.value).toMatchObject({
    name: 'a_b',
    motion: { names: ['JawOpen'], weights: motionOfJaw().weights },
  })
  expect(session.undoLabel.value).toBe('Open a recording')
})
