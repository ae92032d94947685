/** The dialogs that ask for a file. Read first {@link simgsm.ui.file.OpenDialog}. Arrows: ui.file -&gt; nothing of ours. */
package simgsm.ui.file;
