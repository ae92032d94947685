package simgsm.classroom.ui;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import simgsm.console.TextBundle;
import simgsm.ui.ComponentNames;
import simgsm.ui.ReadingArea;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.window.WindowIcon;
import simgsm.ui.window.WindowPlace;
import simgsm.web.QrCode;

/** A window with the browsers' link, as a QR code in the window's size and as text that can be copied. */
public final class LinkFrame {
    private static final int SIDE_UNITS = 420;
    private static final int LEAST_UNITS = 180;
    private static final int LETTERS_UNITS = 21;
    private static final int LINES = 2;

    private final Locale language;
    private final String link;
    private final Optional<WindowPlace> room;
    private final Consumer<Boolean> lock;
    /** Null until opened. */
    private JFrame frame;

    /**
     * Creates an unopened window.
     *
     * @param room of the screen that no other window covers; if absent or too small, the window opens in front
     * @param lock receives true to refuse new browsers
     */
    public LinkFrame(Locale language, String link, Optional<WindowPlace> room, Consumer<Boolean> lock) {
        this.language = language;
        this.link = link;
        this.room = room;
        this.lock = lock;
    }

    /**
     * Opens the window, the next time in full-screen size; it lasts as long as the program's other windows. On the
     * event thread.
     */
    public void open() {
        if (frame != null) {
            frame.setExtendedState(JFrame.MAXIMIZED_BOTH);
            frame.setVisible(true);
            frame.toFront();
            return;
        }
        TextBundle texts = ClassroomTexts.in(language);
        frame = new JFrame(texts.of("link.title"));
        frame.setIconImages(WindowIcon.images(Symbol.PHONE));
        frame.setContentPane(content(texts));
        frame.setAutoRequestFocus(false);
        Optional<WindowPlace> place = room.filter(free -> free.height() >= Theme.px(LEAST_UNITS));
        if (place.isPresent()) {
            place.get().applyTo(frame);
            frame.setVisible(true);
        } else {
            frame.pack();
            frame.setLocationByPlatform(true);
            frame.setVisible(true);
            EventQueue.invokeLater(frame::toFront);
        }
    }

    JPanel content(TextBundle texts) {
        JTextArea letters = new ReadingArea(link);
        letters.setWrapStyleWord(false); // a link has no spaces to wrap at
        letters.setRows(LINES);
        letters.setMinimumSize(
                new Dimension()); // otherwise that of a line for each letter, which the frame would grow to
        letters.setCaretPosition(0);
        Theme.styled(letters, it -> it.setFont(Theme.sans(LETTERS_UNITS, false)));
        JPanel panel = new JPanel(new BorderLayout(Theme.px(Theme.GRID), Theme.px(Theme.GRID)));
        panel.setBorder(Theme.padding(Theme.GRID));
        panel.add(ComponentNames.name(new CodeView(new QrCode(link)), "link.code", texts.of("link.code")));
        JCheckBox locked =
                ComponentNames.name(new JCheckBox(texts.of("link.lock")), "link.lock", texts.of("link.lock"));
        locked.addItemListener(event -> lock.accept(locked.isSelected()));
        JPanel below = new JPanel(new BorderLayout());
        below.add(ComponentNames.name(letters, "link.letters", texts.of("link.letters")));
        below.add(locked, BorderLayout.SOUTH);
        panel.add(below, BorderLayout.SOUTH);
        return panel;
    }

    /** The code, black on white in all themes, as readers expect. */
    private static final class CodeView extends JPanel {
        private final QrCode code;

        CodeView(QrCode code) {
            this.code = code;
            setOpaque(false);
            setPreferredSize(new Dimension(Theme.px(SIDE_UNITS), Theme.px(SIDE_UNITS)));
        }

        @Override
        protected void paintComponent(Graphics g) {
            int modules = code.size() + 2 * QrCode.QUIET_ZONE;
            int module = Math.max(1, Math.min(getWidth(), getHeight()) / modules);
            int left = (getWidth() - module * modules) / 2;
            int top = (getHeight() - module * modules) / 2;
            g.setColor(Color.WHITE);
            g.fillRect(left, top, module * modules, module * modules);
            g.setColor(Color.BLACK);
            for (int row = 0; row < code.size(); row++) {
                for (int column = 0; column < code.size(); column++) {
                    if (code.isDark(column, row)) {
                        g.fillRect(
                                left + (column + QrCode.QUIET_ZONE) * module,
                                top + (row + QrCode.QUIET_ZONE) * module,
                                module,
                                module);
                    }
                }
            }
        }
    }
}
