import { fileURLToPath } from 'node:url'
import { SOURCES } from '../../scripts/lib/sources.mjs'
import { repositoryAddress } from '../places.mjs'
import { NAVIGATION, sidebar } from './contents.mjs'
import { indentedCode } from './indented-code.mjs'
import { repositoryLinks } from './links.mjs'
import { slugOf } from './slug.mjs'

const folder = (path) => fileURLToPath(new URL(path, import.meta.url))

/** Icon of the site and the studio. */
const ICON =
  "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 32 32'><rect width='32' height='32' rx='7' fill='%2324272c'/><path d='M6 11q10-5 20 0M6 17q10-5 20 0M6 23q10-5 20 0' fill='none' stroke='%23e6b48c' stroke-width='2.4' stroke-linecap='round'/></svg>"

const address = repositoryAddress()

export default {
  title: 'Furrow',
  description: 'Real-time wrinkles for any glTF character, in the browser.',
  lang: 'en',
  srcDir: './pages',
  outDir: './dist',
  // Relative URLs let the site work under any path of a server.
  base: './',
  // These links are dead while VitePress builds its pages. `npm run site` builds the studio and the live examples
  // later.
  ignoreDeadLinks: [/\/studio\//, /\/examples\/live\//],
  head: [
    ['link', { rel: 'icon', href: ICON }],
    ['meta', { name: 'theme-color', content: '#24272c' }],
  ],
  markdown: {
    anchor: { slugify: slugOf },
    toc: { slugify: slugOf },
    headers: { slugify: slugOf },
    // These themes have a contrast of at least 4.5 to the background of code blocks.
    theme: { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' },
    config(markdown) {
      repositoryLinks(markdown)
      indentedCode(markdown)
    },
  },
  // By default, VitePress recalculates the style of the whole page twice when a page loads.
  appearance: { disableTransition: false },
  themeConfig: {
    logo: { src: ICON, alt: '' },
    nav: NAVIGATION,
    sidebar: await sidebar(),
    outline: { level: [2, 3] },
    search: { provider: 'local' },
    socialLinks: address ? [{ icon: 'github', link: address, ariaLabel: 'Repository' }] : [],
    footer: { message: 'MIT licence. The faces are CC0.' },
    docFooter: { prev: false, next: false },
    externalLinkIcon: true,
  },
  vite: {
    // The page with the benchmark imports source files of the library. All other imports also resolve to sources,
    // because a second copy of the library would have its own state.
    resolve: SOURCES.resolve,
    cacheDir: folder('../../node_modules/.vite/site'),
    worker: { format: 'es' },
    build: { chunkSizeWarningLimit: 2500 },
  },
}
