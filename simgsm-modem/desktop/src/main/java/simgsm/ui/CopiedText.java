package simgsm.ui;

import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.StringSelection;

/** Puts texts on the desktop's clipboard. */
public final class CopiedText {
    private CopiedText() {}

    /** @return false if the clipboard is busy, because another program holds it at this moment */
    public static boolean copy(String text) {
        return copy(text, Toolkit.getDefaultToolkit().getSystemClipboard());
    }

    static boolean copy(String text, Clipboard clipboard) {
        try {
            clipboard.setContents(new StringSelection(text), null);
            return true;
        } catch (IllegalStateException busy) {
            return false;
        }
    }
}
