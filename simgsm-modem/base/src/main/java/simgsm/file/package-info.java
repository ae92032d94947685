/** Files: the text of those that users name, errors that name them, and writing in one step. */
package simgsm.file;
