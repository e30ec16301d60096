/** After the messages and events that have come. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve))
}

/** Milliseconds after which work begins although the page is busy: a face that moves leaves it no rest. */
const PATIENCE = 200

/** Waits until the page has nothing else to do: what follows is a task of its own. */
export function whenIdle(): Promise<void> {
  return new Promise((resolve) => {
    // Safari has none.
    if (typeof requestIdleCallback === 'undefined') setTimeout(resolve, PATIENCE)
    else requestIdleCallback(() => resolve(), { timeout: PATIENCE })
  })
}

let last = Promise.resolve()

/** Runs a task once the page has nothing else to do and all that came before are done, each in a task of its own. Returns what cancels it. */
export function runInTurn(task: () => void): () => void {
  let isWanted = true
  last = last
    .then(() => (isWanted ? whenIdle() : undefined))
    .then(() => {
      if (isWanted) task()
    })
    .catch((error) => reportError(error))
  return () => {
    isWanted = false
  }
}
