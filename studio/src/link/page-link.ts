import { AUTO_SETTINGS } from '../document/document.ts'
import { linkNote, loadingLabel } from '../labels/messages.ts'
import type { Loading } from '../loading.ts'
import type { Messages } from '../messages.ts'
import type { Workspace } from '../session/workspace.ts'
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
  /** Stops motion, and then runs a function that changes the pose and the camera. */
  set(write: () => void): void
}

/** Applies the link in the hash of the page's URL. Copies links that open the current state. */
export class PageLink {
  readonly #parts: PageLinkParts
  #link: Link | null = null

  constructor(parts: PageLinkParts) {
    this.#parts = parts
    addEventListener('hashchange', () => void this.#follow())
  }

  /** Reads the link from the page's URL. If the link is invalid, shows an error and ignores the link. */
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

  /** Whether the page's URL has a link. */
  get isGiven(): boolean {
    return this.#link !== null
  }

  /** Function that loads the model of the link, or null if the link has no model. */
  get load(): LoadAvatar | null {
    const model = this.#link?.model
    if (model === undefined) return null
    const title = loadingLabel(fileNameOf(model))
    return () => {
      const { loading } = this.#parts
      loading.show(title)
      return fetchAvatar(model, (fraction) => loading.show(title, fraction))
    }
  }

  /** Applies the pose, the camera and the light of the link. Returns false if there is no link or no face. */
  show(): boolean {
    const [link, scene] = [this.#link, this.#scene]
    if (!link || !scene) return false
    this.#parts.set(() => applyLink(link, scene))
    return true
  }

  /** Returns the hash of a link that opens the current state, or null if there is no face. */
  hash(): string | null {
    const scene = this.#scene
    if (!scene) return null
    const link = linkOf(scene, this.#parts.workspace.session.document.peek()?.auto)
    return `#${formatLink(link, location.href)}`
  }

  /** Applies the pose, the camera and the light of a hash. */
  restore(hash: string): void {
    const scene = this.#scene
    if (scene) this.#parts.set(() => applyLink(parseLink(hash, location.href), scene))
  }

  /** Copies a link that opens the current state, and sets the page's URL to this link. */
  async copy(): Promise<void> {
    const { messages, host } = this.#parts
    const hash = this.hash()
    if (hash === null) return
    history.replaceState(null, '', hash)
    // Users can deny access to the clipboard. Insecure pages have no clipboard.
    const isCopied = await navigator.clipboard?.writeText(location.href).then(
      () => true,
      () => false,
    )
    messages.note(linkNote(isCopied ?? false, host.viewer?.avatar.address !== undefined))
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
