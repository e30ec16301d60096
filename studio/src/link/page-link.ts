import type { Loading } from '../loading.ts'
import type { Messages } from '../messages.ts'
import { AUTO_SETTINGS, type Workspace } from '../session/workspace.ts'
import { fetchAvatar, fileNameOf } from '../viewer/faces.ts'
import type { LoadAvatar, ViewerHost } from '../viewer/viewer-host.ts'
import { formatLink, type Link, parseLink } from './link.ts'
import { applyLink, linkOf, type ShownScene } from './viewer-link.ts'

export interface PageLinkParts {
  host: ViewerHost
  workspace: Workspace
  messages: Messages
  loading: Loading
  light: ShownScene['light']
  /** Runs changes of blendshapes and camera. */
  set(write: () => void): void
}

/** Link in the hash of the page's URL: applies it, and makes links to the current state. */
export class PageLink {
  readonly #parts: PageLinkParts
  #link: Link | null = null

  constructor(parts: PageLinkParts) {
    this.#parts = parts
    addEventListener('hashchange', () => void this.#follow())
  }

  /** Reads the link. Shows an error and ignores the link if it is invalid. */
  async read(): Promise<void> {
    this.#link = null
    if (location.hash.length < 2) return
    const { messages, workspace } = this.#parts
    await messages.attempt(() => {
      const link = parseLink(location.hash, location.href)
      this.#link = link
      workspace.initialSettings = link.auto ?? AUTO_SETTINGS
    })
  }

  /** Loader of the link's model, or null. */
  get load(): LoadAvatar | null {
    const model = this.#link?.model
    if (model === undefined) return null
    const title = `Loading ${fileNameOf(model)}`
    return () => {
      const { loading } = this.#parts
      loading.show(title)
      return fetchAvatar(model, (fraction) => loading.show(title, fraction))
    }
  }

  /** Applies the pose and the camera of the link. Returns whether there is a link. */
  show(): boolean {
    const [link, scene] = [this.#link, this.#scene]
    if (!link || !scene) return false
    this.#parts.set(() => applyLink(link, scene))
    return true
  }

  /** Copies a link to the current state, and sets the page's URL to it. */
  async copy(): Promise<void> {
    const { workspace, messages } = this.#parts
    const scene = this.#scene
    if (!scene) return
    const link = linkOf(scene, workspace.session.document.peek()?.auto)
    history.replaceState(null, '', `#${formatLink(link, location.href)}`)
    const contents = link.model === undefined ? 'the avatar itself is not in it' : 'it opens this avatar'
    // The clipboard can be denied, and is missing on insecure pages.
    const isCopied = await navigator.clipboard?.writeText(location.href).then(
      () => true,
      () => false,
    )
    messages.note(
      isCopied ? `Copied the link: ${contents}` : `The link is in the address of this page: ${contents}`,
    )
  }

  get #scene(): ShownScene | null {
    const { host, light } = this.#parts
    const { viewer, orbit } = host
    return viewer && orbit && { viewer, orbit, light }
  }

  async #follow(): Promise<void> {
    await this.read()
    const { load } = this
    const { host } = this.#parts
    if (load) await host.open(host.viewer?.kind ?? 'webgl', load)
    this.show()
  }
}
