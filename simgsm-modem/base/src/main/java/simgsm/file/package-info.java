/** Files that users name: their text, and errors that name them. */
package simgsm.file;
