/** Measures the memory of a page's web workers over the DevTools protocol. */
export class WorkerSessions {
  #session
  #ids = new Set()
  #answers = new Map()
  #next = 1

  static async attach(session) {
    const workers = new WorkerSessions(session)
    await session.send('Target.setAutoAttach', {
      autoAttach: true,
      waitForDebuggerOnStart: false,
      flatten: false,
    })
    return workers
  }

  constructor(session) {
    this.#session = session
    session.on('Target.attachedToTarget', ({ sessionId }) => this.#ids.add(sessionId))
    session.on('Target.detachedFromTarget', ({ sessionId }) => this.#ids.delete(sessionId))
    session.on('Target.receivedMessageFromTarget', ({ message }) => {
      const { id, result } = JSON.parse(message)
      this.#answers.get(id)?.(result)
    })
  }

  /** Collects garbage in all workers. Returns the sum of their heaps in bytes, including typed arrays. */
  async heap() {
    let bytes = 0
    for (const sessionId of this.#ids) {
      await this.#ask(sessionId, 'HeapProfiler.collectGarbage')
      const { usedSize, backingStorageSize = 0 } = await this.#ask(sessionId, 'Runtime.getHeapUsage')
      bytes += usedSize + backingStorageSize
    }
    return bytes
  }

  async #ask(sessionId, method) {
    const id = this.#next++
    const answer = new Promise((resolve) => this.#answers.set(id, resolve))
    await this.#session.send('Target.sendMessageToTarget', {
      sessionId,
      message: JSON.stringify({ id, method }),
    })
    return answer
  }
}
