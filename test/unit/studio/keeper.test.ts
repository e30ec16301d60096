import { beforeEach, expect, it, vi } from 'vitest'
import { setArea } from '../../../studio/src/document/areas.ts'
import type { Project } from '../../../studio/src/keep/project.ts'
import type { ProjectStore } from '../../../studio/src/keep/project-store.ts'
import type { OpenedAvatar } from '../../../studio/src/open/avatar.ts'
import { Keeper } from '../../../studio/src/session/keeper.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { sampleDocument } from './sample-document.ts'

/** Project that another tab has open until the test calls `end`. */
class FakeProject {
  readonly opened = sampleDocument()
  readonly save = vi.fn(async () => {})
  isReadOnly = true
  isClosed = false
  /** Ends the wait. @param isNewer whether the other tab has saved the project. */
  end: (isNewer: boolean) => Promise<void> = async () => {}

  reclaim(): Promise<boolean> {
    return new Promise((resolve) => {
      this.end = async (isNewer) => {
        this.isReadOnly = isNewer
        resolve(isNewer)
        await new Promise((done) => setTimeout(done))
      }
    })
  }

  onRequested(): void {}

  async close(): Promise<void> {
    this.isClosed = true
  }
}

let session: Session
let project: FakeProject
let keeper: Keeper

beforeEach(() => {
  vi.stubGlobal('document', Object.assign(new EventTarget(), { visibilityState: 'visible' }))
  session = new Session()
  project = new FakeProject()
  session.open(project.opened)
  const avatar = { name: 'face', files: [] } as unknown as OpenedAvatar
  keeper = new Keeper({} as ProjectStore, session, avatar, project as unknown as Project, () => {})
})

it('a tab saves again when the other tab has closed the project', async () => {
  session.edit('Change', (document) => setArea(document, 'frown', { activation: 0.5 }))
  expect(keeper.state.value).toEqual({ kind: 'elsewhere' })
  expect(project.save).not.toHaveBeenCalled()
  await project.end(false)
  expect(keeper.state.value?.kind).not.toBe('elsewhere')
  await vi.waitFor(() => expect(project.save).toHaveBeenCalledWith(session.document.value))
})

it('a tab does not overwrite what the other tab has saved', async () => {
  session.edit('Change', (document) => setArea(document, 'frown', { activation: 0.5 }))
  await project.end(true)
  expect(keeper.state.value).toEqual({ kind: 'newer' })
  expect(project.save).not.toHaveBeenCalled()
})

it('a tab that has left the project does not save it', async () => {
  await keeper.close()
  project.isClosed = false
  await project.end(false)
  expect(project.save).not.toHaveBeenCalled()
  expect(project.isClosed).toBe(true)
})
