/** Spoken words: prompts, and sentences and numbers put together from them. */
package simgsm.words;
