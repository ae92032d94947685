/** Octets of messages and files: a reader that refuses to read past the end, a writer, and immutable strings of octets. */
package simgsm.octets;
