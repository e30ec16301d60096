import type { PageLink } from '../link/page-link.ts'
import type { Workspace } from '../session/workspace.ts'
import type { MeshVisibility } from '../viewer/mesh-visibility.ts'
import type { ViewerHost } from '../viewer/viewer-host.ts'

/** Key of `sessionStorage`, which each tab has of its own. */
const KEY = 'furrow-place'

/** Where the user was in this tab: a project, or a face from the server, and what the stage showed. */
export interface Place {
  readonly project?: string
  readonly face?: string
  /** Hash of a link with pose, camera and light. */
  readonly scene: string
  /** Indices of the hidden meshes in `Viewer.meshes`. */
  readonly hidden: readonly number[]
}

export interface ResumeParts {
  host: ViewerHost
  workspace: Workspace
  link: PageLink
  meshes: MeshVisibility
}

/** Remembers where the user is when the page closes, so that a reload continues there. */
export class Resume {
  readonly #parts: ResumeParts

  constructor(parts: ResumeParts) {
    this.#parts = parts
    addEventListener('pagehide', () => this.#save())
  }

  /** Returns where the user was before a reload. Null if the page was not reloaded. */
  read(): Place | null {
    const [entry] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[]
    if (entry?.type !== 'reload') return null
    try {
      return placeOf(JSON.parse(sessionStorage.getItem(KEY) ?? 'null'))
    } catch {
      return null
    }
  }

  #save(): void {
    const { host, workspace, link, meshes } = this.#parts
    const [scene, viewer] = [link.hash(), host.viewer]
    const project = workspace.keeping.kept.peek()?.id
    try {
      if (scene === null || !viewer) {
        sessionStorage.removeItem(KEY)
        return
      }
      const { avatar } = viewer
      const hidden = meshes.hidden.peek()
      const place: Place = {
        scene,
        hidden: viewer.meshes.flatMap((mesh, i) => (hidden.has(mesh) ? [i] : [])),
        ...(project !== undefined && { project }),
        ...(avatar.address !== undefined && { face: avatar.name }),
      }
      sessionStorage.setItem(KEY, JSON.stringify(place))
    } catch {}
  }
}

function placeOf(value: unknown): Place | null {
  if (typeof value !== 'object' || value === null) return null
  const { project, face, scene, hidden } = value as Record<string, unknown>
  if (typeof scene !== 'string') return null
  return {
    scene,
    hidden: Array.isArray(hidden) ? hidden : [],
    ...(typeof project === 'string' && { project }),
    ...(typeof face === 'string' && { face }),
  }
}
