package blackbox.image;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import simgsm.ui.window.WindowIcon;

/** What a Linux desktop shows of the suite: menu entries, icons, and the page of a software centre. */
final class DesktopFiles {
    private static final int[] ICON_SIDES = {16, 24, 32, 48, 64, 128, 256};
    private static final String COMPONENT = "io.github.simgsm.SimGSM";

    private DesktopFiles() {}

    /**
     * @param share the folder of applications, icons and metainfo
     * @param programs those in the menu
     */
    static void write(Path share, List<ImageProgram> programs, String version, String date) throws IOException {
        Path applications = Files.createDirectories(share.resolve("applications"));
        for (ImageProgram program : programs) {
            Files.writeString(applications.resolve(program.id() + ".desktop"), entry(program));
            for (int side : ICON_SIDES) {
                icon(program, side, share.resolve("icons/hicolor/" + side + "x" + side + "/apps"));
            }
        }
        Path metainfo = Files.createDirectories(share.resolve("metainfo"));
        Files.writeString(metainfo.resolve(COMPONENT + ".metainfo.xml"), metainfo(programs, version, date));
    }

    private static void icon(ImageProgram program, int side, Path folder) throws IOException {
        BufferedImage image = WindowIcon.image(program.symbol(), side);
        Files.createDirectories(folder);
        ImageIO.write(image, "png", folder.resolve(program.id() + ".png").toFile());
    }

    private static String entry(ImageProgram program) {
        String grouped = program.windowClass().isEmpty() ? "" : "StartupWMClass=" + program.windowClass() + "\n";
        return """
                [Desktop Entry]
                Type=Application
                Name=%s
                Comment=%s
                Comment[es]=%s
                Exec=%s
                Icon=%s
                Categories=Education;Robotics;
                Keywords=GSM;DTMF;robot;telephone;
                Keywords[es]=GSM;DTMF;robot;teléfono;
                %s""".formatted(
                        program.name(),
                        program.comment(),
                        program.commentInSpanish(),
                        program.launcher(),
                        program.id(),
                        grouped);
    }

    private static String metainfo(List<ImageProgram> programs, String version, String date) {
        StringBuilder binaries = new StringBuilder();
        programs.forEach(program ->
                binaries.append("    <binary>").append(program.launcher()).append("</binary>\n"));
        return """
                <?xml version="1.0" encoding="UTF-8"?>
                <component type="desktop-application">
                  <id>%s</id>
                  <metadata_license>CC0-1.0</metadata_license>
                  <project_license>MIT</project_license>
                  <name>SimGSM</name>
                  <summary>Drive a robot by telephone</summary>
                  <summary xml:lang="es">Mueva un robot por teléfono</summary>
                  <description>
                    <p>A GSM phone, an SMS/Phone centre and a Pioneer robot with a GSM modem, each a window of its own. Dial the robot and drive it by the tones of the keys, or by SMS, and watch every message of the network.</p>
                    <p xml:lang="es">Un teléfono GSM, un centro de SMS y telefonía y un robot Pioneer con un módem GSM, cada uno en su ventana. Llame al robot y muévalo con los tonos de las teclas, o por SMS, y vea cada mensaje de la red.</p>
                  </description>
                  <launchable type="desktop-id">simgsm.desktop</launchable>
                  <categories>
                    <category>Education</category>
                    <category>Science</category>
                  </categories>
                  <provides>
                %s  </provides>
                  <developer_name>The SimGSM suite's authors</developer_name>
                  <content_rating type="oars-1.1"/>
                  <releases>
                    <release version="%s" date="%s"/>
                  </releases>
                </component>
                """.formatted(COMPONENT, binaries, version, date);
    }
}
