import type { Page } from './page.ts'

/** Progress bar over the stage while a face loads or a renderer starts. */
export class Loading {
  readonly #page: Page

  constructor(page: Page) {
    this.#page = page
  }

  /** @param fraction completed fraction of the work, or null if unknown. */
  show(text: string, fraction: number | null = null): void {
    const { stage, loading, loadingText, progress } = this.#page
    stage.ariaBusy = 'true'
    loading.hidden = false
    if (loadingText.textContent !== text) loadingText.textContent = text
    if (fraction === null) progress.removeAttribute('value')
    else progress.value = fraction
  }

  done(): void {
    this.#page.stage.ariaBusy = 'false'
    this.#page.loading.hidden = true
  }
}

/** Waits until the browser has painted. In a hidden page, which is never painted, waits 100 ms. */
export function nextPaint(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve))
    setTimeout(resolve, 100)
  })
}
