package simgsm.center.ui;

import java.awt.BorderLayout;
import java.awt.Font;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JFrame;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simgsm.center.msc.ExchangeSnapshot;

/** The centre's window. */
public final class MonitorWindow {
    private static final int REFRESH_MILLIS = 200;
    private static final int LADDER_ROWS = 30;

    private final JFrame frame = new JFrame("SMSyCT");
    private final JTextArea text = new JTextArea(36, 90);
    private final Operator operator;

    private MonitorWindow(Operator operator) {
        this.operator = operator;
        text.setEditable(false);
        text.setFont(new Font(Font.MONOSPACED, Font.PLAIN, 13));
        frame.add(new JScrollPane(text), BorderLayout.CENTER);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                operator.quit();
            }
        });
    }

    /**
     * Opens the window; returns at once.
     *
     * @param place where its top left corner goes, "X,Y"
     */
    public static void open(Operator operator, Locale language, Optional<String> place) {
        SwingUtilities.invokeLater(() -> new MonitorWindow(operator).show());
    }

    private void show() {
        frame.pack();
        frame.setVisible(true);
        new Timer(REFRESH_MILLIS, tick -> operator.snapshot().ifPresent(this::refresh)).start();
    }

    private void refresh(ExchangeSnapshot snapshot) {
        String subscribers = snapshot.subscribers().stream()
                .map(row -> row.number() + (row.attached() ? " attached" : " detached"))
                .collect(Collectors.joining("\n"));
        String ladder = snapshot.ladder().stream()
                .skip(Math.max(0, snapshot.ladder().size() - LADDER_ROWS))
                .map(entry -> String.format("%12s -> %-12s %s", entry.from(), entry.to(), entry.name()))
                .collect(Collectors.joining("\n"));
        text.setText("port " + operator.port() + "\n\n" + subscribers + "\n\n" + ladder);
    }
}
