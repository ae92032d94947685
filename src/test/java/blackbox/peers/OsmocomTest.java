package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.Dist;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Phones and robots on a real Osmocom core: the cells speak RSL to osmo-bsc. */
@Tag("core")
class OsmocomTest {
    private static final long PATIENCE_MINUTES = 5;
    /** {@code -Dkills=50} and {@code -Dwalks=20} measure for longer. */
    private static final int KILLS = Integer.getInteger("kills", 1);

    private static final int WALKS = Integer.getInteger("walks", 1);

    @BeforeEach
    void thePeersAreThere() {
        for (Peer peer : List.of(
                Peer.OSMO_STP,
                Peer.OSMO_HLR,
                Peer.OSMO_MGW,
                Peer.OSMO_MSC,
                Peer.OSMO_BSC,
                Peer.OSMO_BTS,
                Peer.TSHARK,
                Peer.BASH)) {
            peer.require();
        }
    }

    @Test
    void anOrderGoesOnAcrossAHandoverBetweenTwoTowers(@TempDir Path folder) throws Exception {
        Path town = Dist.root().resolve("worlds").resolve("village.town");
        String told = session(folder, "session", town, "5550100,5550200");
        assertTrue(told.contains("handed over in the middle of an order"), told);
    }

    /** The core asks for authentication and ciphering; the keys are those of Milenage's test sets 1 and 3 (TS 35.207). */
    @ParameterizedTest
    @ValueSource(strings = {"a5/1", "a5/3"})
    void aCoreThatAuthenticatesAndCiphersServesPhoneAndRobot(String a5, @TempDir Path folder) throws Exception {
        Peer.PYTHON.require();
        Files.writeString(folder.resolve("sims.txt"), """
                sim number=5550100 imsi=001010005550100 k=465b5ce8b199b49faa5f0a2ee238a6bc opc=cd63cb71954a9f4e48a5994e37a02baf
                sim number=5550101 imsi=001010005550101 k=465b5ce8b199b49faa5f0a2ee238a6bc algorithm=comp128v2
                sim number=5550200 imsi=001010005550200 k=fec86ba6eb707ed08905757b1bb44b8f opc=1006020f0a478bf6b699f15c062e42b3
                """);
        Path town = Dist.root().resolve("worlds").resolve("village.town");
        String sims = folder.resolve("sims.txt").toString();
        String told = session(
                folder,
                a5,
                town,
                "5550100,5550101,5550200",
                Map.of("OSMOCOM_SIMS", sims, "OSMOCOM_A5", a5.equals("a5/3") ? "0 1 3" : "0 1"));
        assertTrue(told.contains("handed over in the middle of an order"), told);
        assertTrue(told.contains("without-key 0"), told);
        assertTrue(told.contains("a card with another Kc is not registered"), told);
    }

    @Test
    void aHundredPhonesRegisterAndSendEachOtherMessages(@TempDir Path folder) throws Exception {
        String told = session(folder, "crowd", Path.of(Peer.source("osmocom/crowd.town")), "7000000-7000099");
        assertTrue(told.contains("100 phones: "), told);
    }

    /** Each of ten towers has traffic channels for its four phones; so all 20 calls are held at once. */
    @Test
    void twentyCallsHoldAndCarrySpeech(@TempDir Path folder) throws Exception {
        String crowd = Files.readString(Path.of(Peer.source("osmocom/crowd.town")));
        Path town = Files.writeString(folder.resolve("calls.town"), crowd.replace("tch=1", "tch=4"));
        String told = session(folder, "calls", town, "7000000-7000039");
        assertTrue(told.contains("20 calls were held, "), told);
    }

    @Test
    void twoCellsProgramsShareOneCore(@TempDir Path folder) throws Exception {
        Path town = Dist.root().resolve("worlds").resolve("village.town");
        String told = session(folder, "halves", town, "5550100,5550200");
        assertTrue(told.contains("two cells programs on one core: "), told);
    }

    @Test
    void aBrowserIsAPhoneOfTheCore(@TempDir Path folder) throws Exception {
        Path town = Dist.root().resolve("worlds").resolve("village.town");
        String told = session(folder, "browser", town, "5550100,5550200");
        assertTrue(told.contains("a browser's orders by short message and by tones"), told);
    }

    /** Its home register has the keys of cards with COMP128 versions 1 to 3 and Milenage. */
    @Test
    void cardsOfEachAlgorithmAreAuthenticatedAndOneWithoutPinCallsForHelp(@TempDir Path folder) throws Exception {
        Path cards = Files.writeString(folder.resolve("cards.sim"), OsmocomSession.cards());
        Path town = Dist.root().resolve("worlds").resolve("village.town");
        String told =
                session(folder, "cards", town, "5550100-5550105,5550200", Map.of("OSMOCOM_SIMS", cards.toString()));
        assertTrue(told.contains("comp128v1, comp128v2, comp128v3 and milenage are authenticated"), told);
        assertTrue(told.contains("an emergency call was answered by the robot"), told);
    }

    /** At both ends of GSM 900, and in two bands; with {@code -Dwalks} also channels far apart in DCS 1800. */
    static List<String> towns() {
        List<String> always = List.of("975 110", "100 600 110 885");
        return System.getProperty("walks") == null
                ? always
                : Stream.concat(always.stream(), Stream.of("600 800 700", "512 885"))
                        .toList();
    }

    @ParameterizedTest
    @MethodSource("towns")
    void aCallIsKeptThereAndBackThroughATown(String arfcns, @TempDir Path folder) throws Exception {
        Peer.PYTHON.require();
        StringBuilder lines = new StringBuilder("town Walk\narea suburban\nshadow 0\n");
        String[] each = arfcns.split(" ");
        for (int i = 0; i < each.length; i++) {
            lines.append("tower t" + i + " " + 2_000 * i + " 0 arfcn=" + each[i] + " bsic=" + (10 + i)
                    + " lac=1 power=50\n");
        }
        Path town = Files.writeString(folder.resolve("walk.town"), lines);
        String told = beside(
                folder,
                town,
                "5550100,5550200",
                String.join(
                        " ",
                        "python3",
                        quoted(Peer.source("osmocom/walks.py")),
                        quoted(town.toString()),
                        String.valueOf(WALKS),
                        quoted(folder.toString()),
                        "osmo-bsc"),
                Map.of(),
                PATIENCE_MINUTES + 2 * WALKS);
        assertTrue(told.contains(WALKS + " of " + WALKS + " walks there and back kept the call"), told);
    }

    /** osmo-msc first, then osmo-hlr, osmo-bsc, osmo-stp in turn. */
    @Test
    void allTerminalsWorkAMinuteAfterAProgramOfTheCoreIsKilled(@TempDir Path folder) throws Exception {
        Peer.PYTHON.require();
        Path town = Dist.root().resolve("worlds").resolve("village.town");
        String told = beside(
                folder,
                town,
                "5550100,5550101,5550200",
                "python3 " + quoted(Peer.source("osmocom/kills.py")) + " " + KILLS + " 3 "
                        + quoted(folder.resolve("logs").toString()),
                Map.of(),
                PATIENCE_MINUTES + 2 * KILLS);
        assertTrue(told.contains(KILLS + " of " + KILLS + " kills: all terminals usable"), told);
    }

    private static String session(Path folder, String kind, Path town, String numbers)
            throws IOException, InterruptedException {
        return session(folder, kind, town, numbers, Map.of());
    }

    /** Runs {@link OsmocomSession} beside a core for a town's towers. */
    private static String session(Path folder, String kind, Path town, String numbers, Map<String, String> environment)
            throws IOException, InterruptedException {
        String command = String.join(
                " ",
                quoted(Path.of(System.getProperty("java.home"), "bin", "java").toString()),
                "-Dsimgsm.root=" + quoted(Dist.root().toString()),
                "-Dsimgsm.dist=" + quoted(System.getProperty("simgsm.dist")),
                "-cp " + quoted(System.getProperty("java.class.path")),
                OsmocomSession.class.getName(),
                kind,
                quoted(folder.resolve("osmocom.pcapng").toString()));
        return beside(folder, town, numbers, command, environment, PATIENCE_MINUTES);
    }

    /** Runs a command beside a core. @return what it printed */
    private static String beside(
            Path folder,
            Path town,
            String numbers,
            String command,
            Map<String, String> environment,
            long patienceMinutes)
            throws IOException, InterruptedException {
        ProcessBuilder core = Peer.BASH.process(Peer.source("osmocom/core.sh"), town.toString(), numbers, command);
        core.environment().putAll(environment);
        core.environment().put("OSMOCOM_LOGS", folder.resolve("logs").toString());
        core.environment().put("JAVA_HOME", System.getProperty("java.home"));
        core.environment().put("SIMGSM_DIST", System.getProperty("simgsm.dist"));
        Path output = folder.resolve("told.txt");
        Process process = core.redirectOutput(output.toFile()).start();
        boolean hasEnded = process.waitFor(patienceMinutes, TimeUnit.MINUTES);
        process.destroy();
        String told = Files.readString(output, StandardCharsets.UTF_8);
        System.out.println(told);
        assertTrue(hasEnded, told);
        assertEquals(0, process.exitValue(), told);
        return told;
    }

    private static String quoted(String word) {
        return "'" + word.replace("'", "'\\''") + "'";
    }
}
