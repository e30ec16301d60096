import type { Page } from './page.ts'

/** The bar over the stage while a face loads or a renderer starts. */
export class Loading {
  readonly #page: Page

  constructor(page: Page) {
    this.#page = page
  }

  /** @param share of the work that is done, null when nobody knows. */
  show(text: string, share: number | null = null): void {
    const { stage, loading, loadingText, progress } = this.#page
    stage.ariaBusy = 'true'
    loading.hidden = false
    if (loadingText.textContent !== text) loadingText.textContent = text
    if (share === null) progress.removeAttribute('value')
    else progress.value = share
  }

  done(): void {
    this.#page.stage.ariaBusy = 'false'
    this.#page.loading.hidden = true
  }
}

/** Lets the browser paint before work that blocks it; where nothing is painted, does not wait for it. */
export function painted(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve))
    setTimeout(resolve, 100)
  })
}
