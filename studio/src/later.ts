/** Waits for a new task, after pending messages and events. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve))
}

/** Maximum wait for an idle page, milliseconds: a moving face is never idle. */
const MAX_WAIT = 200

/** Waits for an idle page. */
export function whenIdle(): Promise<void> {
  return new Promise((resolve) => {
    // Safari lacks requestIdleCallback.
    if (typeof requestIdleCallback === 'undefined') setTimeout(resolve, MAX_WAIT)
    else requestIdleCallback(() => resolve(), { timeout: MAX_WAIT })
  })
}

let last = Promise.resolve()

/** Queues a task for an idle page, after all queued tasks. Returns a function that cancels it. */
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
