/**
 * Caches the built page for offline use. A new build takes over only after all pages of the old build are closed, so builds are never mixed.
 *
 * `offline.ts` adds this file to the build, with the values of the constants.
 */

const FILES: unknown = 'FILES'
const CACHE = `furrow-studio ${'VERSION'}`

/** Event types that TypeScript's DOM library lacks. */
interface LifeEvent extends Event {
  waitUntil(work: Promise<unknown>): void
}
interface RequestEvent extends LifeEvent {
  readonly request: Request
  respondWith(response: Promise<Response>): void
}

addEventListener('install', (event) => {
  const keep = async () => {
    const cache = await caches.open(CACHE)
    // Bypass the HTTP cache, which can hold files of an older build.
    await cache.addAll((FILES as string[]).map((path) => new Request(path, { cache: 'reload' })))
  }
  ;(event as LifeEvent).waitUntil(keep())
})

addEventListener('activate', (event) => {
  const forget = async () => {
    const names = await caches.keys()
    const old = names.filter((name) => name.startsWith('furrow-studio ') && name !== CACHE)
    await Promise.all(old.map((name) => caches.delete(name)))
  }
  ;(event as LifeEvent).waitUntil(forget())
})

addEventListener('fetch', (event) => {
  const { request } = event as RequestEvent
  const isOwn = new URL(request.url).origin === location.origin
  if (request.method !== 'GET' || !isOwn) return
  ;(event as RequestEvent).respondWith(answer(request))
})

/** Answers from the cache, otherwise from the network. Caches responses of the network, because files of a build never change. */
async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE)
  // Ignore the query, which only scripts read, and `Vary: Origin`, which some servers send although the origin does not matter.
  const known = await cache.match(request, { ignoreSearch: true, ignoreVary: true })
  if (known) return known
  const response = await fetch(request)
  if (response.status === 200) await cache.put(request, response.clone()).catch(() => {})
  return response
}
