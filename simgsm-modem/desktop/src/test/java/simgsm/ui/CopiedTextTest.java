package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.ClipboardOwner;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import org.junit.jupiter.api.Test;

class CopiedTextTest {
    @Test
    void aTextStandsOnTheClipboard() throws Exception {
        Clipboard clipboard = new Clipboard("free");
        assertTrue(CopiedText.copy("5550100", clipboard));
        assertEquals("5550100", clipboard.getData(DataFlavor.stringFlavor));
    }

    @Test
    void aBusyClipboardIsReportedAndIsNoError() {
        assertFalse(CopiedText.copy("5550100", new Clipboard("busy") {
            @Override
            public synchronized void setContents(Transferable contents, ClipboardOwner owner) {
                throw new IllegalStateException("cannot open system clipboard");
            }
        }));
    }
}
