/** Client hints (https://wicg.github.io/ua-client-hints), missing in TypeScript's DOM types. */
interface ClientHints {
  getHighEntropyValues(hints: string[]): Promise<{
    fullVersionList?: { brand: string; version: string }[]
    platform: string
    platformVersion?: string
  }>
}

/** Matches the placeholder that Chromium adds to its brand list, such as `Not;A=Brand`. */
const PLACEHOLDER_BRAND = /not.*brand/i

/** Returns browser and operating system with versions, or the user agent if the browser has no client hints. */
export async function browserName(): Promise<string> {
  const { userAgentData } = navigator as { userAgentData?: ClientHints }
  if (!userAgentData) return navigator.userAgent
  const hints = ['fullVersionList', 'platformVersion']
  const {
    fullVersionList = [],
    platform,
    platformVersion = '',
  } = await userAgentData.getHighEntropyValues(hints)
  const brands = fullVersionList.filter(({ brand }) => !PLACEHOLDER_BRAND.test(brand))
  // Chromium-based browsers list Chromium as well as their own brand.
  const own = brands.find(({ brand }) => brand !== 'Chromium') ?? brands[0]
  if (!own) return navigator.userAgent
  return `${own.brand} ${own.version}, ${platform} ${platformVersion}`.trim()
}
