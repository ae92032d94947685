package simgsm.ui.file;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.UIManager;
import simgsm.ui.ComponentNames;

/**
 * Swing's file dialog with the focus in the file's name instead of the list of folders, and starting in the last
 * chosen folder. Its words are in the default language of Swing components.
 */
final class FileQuestion extends JFileChooser {
    /** @param start folder to show; empty for the last choice's, or the user's home */
    FileQuestion(Optional<Path> start) {
        super(start.or(LastFolder::get).map(Path::toFile).orElse(null));
        setFocusTraversalPolicyProvider(true);
        setFocusTraversalPolicy(new LayoutFocusTraversalPolicy() {
            @Override
            public Component getDefaultComponent(Container container) {
                Optional<JTextField> field = nameField(FileQuestion.this);
                return field.isPresent() ? field.get() : super.getDefaultComponent(container);
            }
        });
        nameField(this)
                .ifPresent(field -> field.addFocusListener(new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent event) {
                        selectStem(field);
                    }
                }));
    }

    /** Asks where to save: Nimbus asks where to look for both. */
    void askWhereToSave() {
        String looking = UIManager.getString("FileChooser.lookInLabelText", getLocale());
        String saving = UIManager.getString("FileChooser.saveInLabelText", getLocale());
        parts(this, JLabel.class)
                .filter(label -> looking != null && looking.equals(label.getText()))
                .forEach(label -> label.setText(saving));
    }

    /** Selects the proposed name without its ending, so that typing replaces it. */
    static void selectStem(JTextField field) {
        int dot = field.getText().lastIndexOf('.');
        field.select(0, dot > 0 ? dot : field.getText().length());
    }

    /** The file confirmed by the user; its folder is remembered. */
    static Path chosen(JFileChooser question) {
        Path file = question.getSelectedFile().toPath();
        LastFolder.keepOf(file);
        return file;
    }

    private static <T extends Component> Stream<T> parts(Container container, Class<T> kind) {
        return ComponentNames.all(container).filter(kind::isInstance).map(kind::cast);
    }

    private static Optional<JTextField> nameField(Container container) {
        return parts(container, JTextField.class).filter(Component::isVisible).findFirst();
    }
}
