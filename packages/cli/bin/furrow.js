#!/usr/bin/env node
import { existsSync } from 'node:fs'

const main = new URL('../dist/main.js', import.meta.url)
if (existsSync(main)) {
  await import(main)
} else {
  // Published packages contain dist/; only a clone can lack it.
  console.error('furrow: not built yet; run "npm run build" in the root of the repository')
  process.exitCode = 1
}
