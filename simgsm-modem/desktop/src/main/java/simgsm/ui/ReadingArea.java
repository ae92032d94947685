package simgsm.ui;

import javax.swing.JTextArea;

/** A text of several lines that cannot be edited; lines wrap between words. */
public class ReadingArea extends JTextArea {
    public ReadingArea(String text) {
        super(text);
        setEditable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
    }
}
