package simgsm.classroom.ui;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.file.FileReplacement;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.UserAction;
import simgsm.ui.file.SaveDialog;
import simgsm.ui.window.WindowIcon;
import simgsm.ui.window.WindowKeys;

/** The window of a class. */
public final class ClassFrame {
    private final JFrame frame = new JFrame();
    private final ClassActions actions;
    private ClassPanel panel;
    private Optional<ClassView> newest = Optional.empty();

    private ClassFrame(ClassActions actions) {
        this.actions = actions;
    }

    /**
     * Opens the window, which closes only with the program's other windows; on the event thread. The place is in pixels
     * of the screen.
     */
    public static ClassFrame open(
            Locale language, int x, int y, int width, int height, ClassActions actions, Supplier<ClassView> source) {
        ClassFrame opened = new ClassFrame(actions);
        JFrame frame = opened.frame;
        opened.speak(language);
        // the results cannot be reopened, so they last as long as the class
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                frame.setExtendedState(JFrame.ICONIFIED);
            }
        });
        frame.setBounds(x, y, width, height);
        frame.setIconImages(WindowIcon.images(Symbol.PERSON));
        frame.setVisible(true);
        new SnapshotPoller<>(source, opened::show).start();
        return opened;
    }

    private void show(ClassView view) {
        newest = Optional.of(view);
        panel.show(view);
    }

    /** Sets the language of the class; on the event thread. */
    public void speak(Locale language) {
        panel = new ClassPanel(language, actions, new Frames(ClassroomTexts.in(language)));
        frame.setTitle(ClassroomTexts.in(language).of("class.title"));
        frame.setContentPane(panel);
        WindowKeys.installBeside(frame.getRootPane(), language);
        newest.ifPresent(panel::show);
        frame.validate();
    }

    private record Frames(TextBundle words) implements ClassPanel.Frames {
        @Override
        public void save(Component owner, String csv) throws IOException {
            SaveDialog.Replacing replacing = new SaveDialog.Replacing(
                    name -> words.of("class.save.replace", name),
                    words.of("class.save"),
                    words.of("class.save.yes"),
                    words.of("class.save.cancel"));
            Optional<Path> file = SaveDialog.ask(
                    owner,
                    Path.of("class.csv"),
                    List.of(new SaveDialog.Kind(words.of("class.save.kind"), "csv")),
                    UnaryOperator.identity(),
                    replacing);
            if (file.isPresent()) {
                FileReplacement.write(file.get(), csv.getBytes(StandardCharsets.UTF_8));
            }
        }

        /** Fills the screen with a content; Escape closes it. */
        @Override
        public void openLarge(Component beside, String title, JComponent content) {
            JFrame frame = new JFrame(title, beside.getGraphicsConfiguration());
            frame.setContentPane(content);
            frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
            new UserAction("class.large.close", title, frame::dispose)
                    .bindInWindow(frame.getRootPane(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
            frame.setIconImages(WindowIcon.images(Symbol.PERSON));
            frame.setBounds(beside.getGraphicsConfiguration().getBounds());
            frame.setExtendedState(JFrame.MAXIMIZED_BOTH);
            frame.setVisible(true);
        }
    }
}
