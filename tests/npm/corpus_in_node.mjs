// SPDX-License-Identifier: MIT
//
// corpus_in_node.mjs CORPUS: prints what askCorpus returns, as JSON.
import { readFileSync } from 'node:fs';
import * as predicates from 'asterism-predicates';
import { askCorpus } from './corpus.mjs';

console.log(JSON.stringify(askCorpus(predicates, readFileSync(process.argv[2], 'utf8'))));
