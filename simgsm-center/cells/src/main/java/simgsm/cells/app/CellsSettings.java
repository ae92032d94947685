package simgsm.cells.app;

import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import simgsm.air.CipherAlgorithm;
import simgsm.cells.net.FollowedRobot;
import simgsm.cells.snapshot.HandoverRule;
import simgsm.cells.tower.AirInterface;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownFile;
import simgsm.cells.town.TownReader;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.HostPort;
import simgsm.console.ProgramFolder;
import simgsm.console.UsageException;

/**
 * The options of the command line.
 *
 * @param port for terminals; 0 for any free one
 * @param controller the centre or osmo-bsc
 * @param isOsmocom true for osmo-bsc
 * @param handover the controller's rule, for the window
 * @param algorithms of the air
 * @param gsmtap receiver of the air capture
 * @param reports CSV file of measurement reports
 * @param followed robots whose poses move terminals
 */
public record CellsSettings(
        Town town,
        InetAddress address,
        int port,
        HostPort controller,
        boolean isOsmocom,
        long seed,
        HandoverRule handover,
        List<FollowedRobot> followed,
        Set<CipherAlgorithm> algorithms,
        Optional<InetSocketAddress> gsmtap,
        Optional<Path> reports,
        Locale language) {
    public static final String PROGRAM = "simgsm-cells";
    public static final int DEFAULT_PORT = 3013;
    private static final int MAX_PORT = 0xffff;
    private static final Path TOWNS = Path.of("worlds");
    private static final String RESOURCES = "/simgsm/cells/town-files/";

    /** @throws IOException naming the town file that cannot be read */
    public static CellsSettings read(Arguments arguments) throws UsageException, IOException {
        int port = (int) arguments.integer("port", DEFAULT_PORT, 0, MAX_PORT);
        boolean isOsmocom = arguments.choice("controller", "ours", "osmo-bsc").equals("osmo-bsc");
        HostPort controller = arguments.hostPort("center").orElse(HostPort.parse("127.0.0.1:3003"));
        InetAddress address = arguments.bindAddress();
        long seed = arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE);
        HandoverRule handover = arguments.value("handover", HandoverRule::parse).orElse(HandoverRule.STANDARD);
        Path file = arguments.path("town").orElseThrow(() -> new UsageException("--town FILE.town is needed"));
        Town town = town(ProgramFolder.find(CellsSettings.class, TOWNS, file));
        List<FollowedRobot> followed = new ArrayList<>();
        for (String text : arguments.all("follow")) {
            followed.add(Arguments.checked(() -> FollowedRobot.parse(text)));
        }
        return new CellsSettings(
                town,
                address,
                port,
                controller,
                isOsmocom,
                seed,
                handover,
                List.copyOf(followed),
                arguments.value("a5", CellsSettings::algorithms).orElse(AirInterface.STANDARD.algorithms()),
                arguments.hostPort("gsmtap").map(to -> new InetSocketAddress(to.host(), to.port())),
                arguments.path("reports"),
                arguments.language());
    }

    /** The algorithms of a list such as "0,1,3". */
    private static Set<CipherAlgorithm> algorithms(String text) {
        if (!text.matches("[013](,[013])*")) {
            throw new IllegalArgumentException("expected some of 0,1,3, found " + text);
        }
        return Arrays.stream(text.split(","))
                .map(number -> CipherAlgorithm.valueOf("A5_" + number))
                .collect(Collectors.toCollection(() -> EnumSet.noneOf(CipherAlgorithm.class)));
    }

    /** Reads a file, or a built-in town. */
    private static Town town(Path file) throws IOException {
        Optional<byte[]> carried = Files.exists(file)
                ? Optional.empty()
                : ProgramFolder.carried(CellsSettings.class, TOWNS, file, RESOURCES);
        return carried.isEmpty()
                ? TownFile.read(file)
                : TownReader.read(file.getFileName().toString(), new String(carried.get(), StandardCharsets.UTF_8));
    }

    public InetSocketAddress controllerAddress() {
        return InetSocketAddress.createUnresolved(controller.host(), controller.port());
    }

    /** Prints the configuration of osmo-bsc for the towers. @return the exit status */
    public int printOsmoBsc(PrintStream out) {
        out.print(OsmoBscConfig.of(town));
        out.flush();
        return ExitStatus.OK;
    }
}
