package simgsm.phone.ui;

import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.HandsetLog;
import simgsm.ui.ComponentNames;
import simgsm.ui.DressedPanel;
import simgsm.ui.Theme;
import simgsm.ui.VerticalScrollPane;

/**
 * The log of events, one per line, to be read with the arrow keys and copied. Digits, Enter and Escape remain keys of
 * the phone.
 */
final class EventsPanel extends DressedPanel {
    private final WordsText words;
    private final JTextArea area = new Lines();
    private List<HandsetLog.Entry> shown = List.of();

    /** Restores caret position and null keymap after a change of the look and feel; without a keymap typed digits reach the phone. */
    private static final class Lines extends JTextArea {
        @Override
        public void updateUI() {
            int place = getCaret() == null ? 0 : getCaretPosition();
            super.updateUI();
            setKeymap(null);
            if (place > 0) {
                setCaretPosition(place);
            }
        }
    }

    EventsPanel(TextBundle texts, WordsText words) {
        this.words = words;
        setOpaque(false);
        ComponentNames.name(area, "events", texts.of("events.title"));
        area.getAccessibleContext().setAccessibleDescription(texts.of("events.hint"));
        area.setEditable(false);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        for (int key : new int[] {KeyEvent.VK_ENTER, KeyEvent.VK_ESCAPE, KeyEvent.VK_BACK_SPACE}) {
            area.getInputMap().put(KeyStroke.getKeyStroke(key, 0), "none");
        }
        JScrollPane pane = new VerticalScrollPane(area);
        ComponentAdapter follower = new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                showEnd();
            }
        };
        pane.getViewport().addComponentListener(follower);
        area.addComponentListener(follower);
        add(pane);
        dress();
    }

    /** Scrolls to the end, if the caret is there, after the panel was opened or resized. */
    private void showEnd() {
        int end = area.getDocument().getLength();
        if (area.getCaretPosition() == end) {
            area.scrollRectToVisible(new Rectangle(0, area.getHeight() - 1, 1, 1));
        }
    }

    /** Adds the new events. A caret at the end remains at the end. */
    void show(List<HandsetLog.Entry> entries) {
        if (entries == shown) {
            return;
        }
        boolean isAtEnd = area.getCaretPosition() == area.getDocument().getLength();
        removeOldest(entries);
        int length = area.getDocument().getLength();
        int same = 0;
        while (same < Math.min(shown.size(), entries.size()) && shown.get(same) == entries.get(same)) {
            same++;
        }
        int kept = lines(entries.subList(0, same)).length();
        area.replaceRange(lines(entries.subList(same, entries.size())), kept, length);
        shown = entries;
        if (isAtEnd) {
            area.setCaretPosition(area.getDocument().getLength());
        }
    }

    /** Removes the lines of events that the log has dropped, so that the caret keeps its line. */
    private void removeOldest(List<HandsetLog.Entry> entries) {
        int gone = 0;
        while (gone < shown.size() && (entries.isEmpty() || shown.get(gone) != entries.get(0))) {
            gone++;
        }
        area.replaceRange("", 0, lines(shown.subList(0, gone)).length());
        shown = shown.subList(gone, shown.size());
    }

    private String lines(List<HandsetLog.Entry> entries) {
        return entries.stream().map(entry -> line(entry) + "\n").collect(Collectors.joining());
    }

    private String line(HandsetLog.Entry entry) {
        return words.time(entry.at()) + "  " + words.of(entry.words());
    }

    void focus() {
        area.requestFocusInWindow();
    }

    boolean hasFocusInside() {
        return area.isFocusOwner();
    }

    @Override
    protected void dress() {
        area.setFont(Theme.base());
        area.setForeground(Theme.color(Ink.TEXT));
        area.setMargin(new Insets(Theme.px(4), Theme.px(6), Theme.px(4), Theme.px(6)));
    }
}
