// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Asks the search of a site, as a browser does it, with Node.js: node search.js SITE QUERIES, a list in JSON. Prints for each
// the pages that are found, the best first, as a list of lists in JSON.
const fs = require('fs'), path = require('path');
const [site, queries] = process.argv.slice(2);
const index = JSON.parse(fs.readFileSync(path.join(site, 'search/search_index.json'), 'utf8'));
const page = fs.readFileSync(path.join(site, 'index.html'), 'utf8');
const settings = JSON.parse(page.match(/<script id="__config"[^>]*>(.*?)<\/script>/s)[1]);
// Version 8 of the theme has settings in the page, which stand in for those that the plugin of the search leaves at their
// defaults; version 9 has all of them in the index.
const config = {...index.config}, text = key => settings.translations[`search.config.${key}`];
if (text('lang')) {
  if (config.lang.length === 1 && config.lang[0] === 'en') config.lang = [text('lang')];
  if (config.separator === '[\\s\\-]+') config.separator = text('separator');
}
const pipeline = text('pipeline') ? text('pipeline').split(/\s*,\s*/).filter(Boolean) : config.pipeline;

globalThis.self = globalThis;
let answer;
globalThis.addEventListener = (_, handler) => { globalThis.ask = data => handler({data}); };
globalThis.postMessage = message => answer(message);
const post = message => new Promise(resolve => { answer = resolve; globalThis.ask(message); });

(async () => {
  require(path.resolve(site, settings.search));
  await post({type: 0, data: {config, docs: index.docs, options: {pipeline, suggestions: true, suggest: true}}});
  const found = [];
  for (const query of JSON.parse(queries)) {
    // As the box of the page does: words that follow each other, without signs that the syntax of queries has.
    const words = query.replace(/(?:^|\s+)[*+\-:^~]+(?=\s+|$)/g, '').trim();
    const {data} = await post({type: 2, data: words});
    found.push(data.items.map(sections => sections[0].location.replace(/#.*/, '')));
  }
  console.log(JSON.stringify(found));
})();
