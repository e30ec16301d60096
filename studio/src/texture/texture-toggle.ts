import type { TextureViewParts } from './texture-view.ts'

/** Button that toggles the texture view. Downloads the code of the view at the first press. */
export class TextureToggle {
  readonly #button: HTMLButtonElement
  readonly #parts: TextureViewParts
  #view: Promise<unknown> | null = null

  constructor(button: HTMLButtonElement, parts: TextureViewParts) {
    this.#button = button
    this.#parts = parts
    button.addEventListener('click', () => this.#show(Boolean(parts.element.hidden)))
  }

  #show(isShown: boolean): void {
    const { element, attempt } = this.#parts
    element.hidden = !isShown
    this.#button.ariaPressed = String(isShown)
    this.#view ??= import('./texture-view.ts').then(({ TextureView }) => new TextureView(this.#parts))
    void attempt(() => this.#view)
  }
}
