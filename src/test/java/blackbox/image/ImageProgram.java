package blackbox.image;

import java.lang.module.ModuleFinder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import simgsm.ui.Symbol;

/**
 * A program of the image: its launcher, module, first arguments, and what a desktop's menu shows of it.
 *
 * @param symbol the pictogram of its icon; null for a program without a window
 * @param windowClass the class by which X11 desktops group its windows: the main class, dots as hyphens
 */
record ImageProgram(
        String launcher,
        String module,
        List<String> arguments,
        Symbol symbol,
        String windowClass,
        String name,
        String comment,
        String commentInSpanish) {
    private static final List<ImageProgram> ALL = List.of(
            new ImageProgram(
                    "simgsm",
                    "simgsm.center",
                    List.of("--demo"),
                    Symbol.CALL,
                    "",
                    "SimGSM",
                    "Drive a robot by telephone: centre, phone and robot in three windows",
                    "Mueva un robot por teléfono: centro, teléfono y robot en tres ventanas"),
            new ImageProgram(
                    "simgsm-center",
                    "simgsm.center",
                    List.of(),
                    Symbol.BROADCAST,
                    "simgsm-center-CenterMain",
                    "SMSyCT",
                    "The SMS/Phone centre: a GSM network with a live view of its messages",
                    "El centro de SMS y telefonía: una red GSM con sus mensajes a la vista"),
            new ImageProgram(
                    "simgsm-phone",
                    "simgsm.phone",
                    List.of(),
                    Symbol.PHONE,
                    "simgsm-phone-PhoneMain",
                    "Sim Cellular",
                    "A GSM phone that dials robots and writes messages",
                    "Un teléfono GSM que llama a robots y escribe mensajes"),
            new ImageProgram(
                    "simrobot",
                    "simrobot",
                    List.of(),
                    Symbol.ROBOT,
                    "simrobot-SimRobotMain",
                    "SimRobot",
                    "A Pioneer robot with a GSM modem in a world of walls",
                    "Un robot Pioneer con un módem GSM en un mundo de paredes"),
            new ImageProgram(
                    "simgsm-cells",
                    "simgsm.cells",
                    List.of(),
                    Symbol.BROADCAST,
                    "simgsm-cells-CellsMain",
                    "SimGSM cells",
                    "The towers of a town between terminals and the centre",
                    "Las torres de una ciudad entre los terminales y el centro"),
            new ImageProgram("simgsm-gateway", "simgsm.gateway", List.of(), null, "", "", "", ""),
            new ImageProgram("simgsm-modem", "simgsm.tools", List.of(), null, "", "", "", ""),
            new ImageProgram("vericommand", "vericommand", List.of(), null, "", "", "", ""));

    /** The programs whose modules the build has left. */
    static List<ImageProgram> in(Path dist) {
        ModuleFinder modules = ModuleFinder.of(dist);
        return ALL.stream()
                .filter(program -> modules.find(program.module).isPresent())
                .toList();
    }

    /** The modules of the programs, each once. */
    static List<String> modules(List<ImageProgram> programs) {
        return programs.stream().map(ImageProgram::module).distinct().toList();
    }

    /** Whether the program is in a desktop's menu. The cells have a window only where their module requires the desktop. */
    boolean isInMenu(Path dist) {
        return symbol != null
                && ModuleFinder.of(dist).find(module).orElseThrow().descriptor().requires().stream()
                        .anyMatch(required -> required.name().equals("simgsm.desktop"));
    }

    /** The icon's and the desktop file's name. */
    String id() {
        return launcher;
    }

    /** The name of its cache of linked classes, the same for programs of one module. */
    String cacheName() {
        return module.replace('.', '-');
    }

    /** The words after the Java machine's options that start it, each for a shell. */
    String words() {
        return String.join(" ", Arrays.asList("-m", module, String.join(" ", arguments)))
                .strip();
    }
}
