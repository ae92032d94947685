package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Programs that were written elsewhere read our fax pages: libtiff's, and SpanDSP, which sends and receives them. */
@Tag("peer")
class FaxPeersTest {
    @TempDir
    Path folder;

    private final Scenario scenario = new Scenario("fax");
    private Path fax;

    @BeforeEach
    void start() {
        scenario.center("--smpp", "0");
        RunningProgram phone = scenario.phone(Scenario.PHONE);
        RunningProgram gateway = scenario.faxGateway(scenario.smppPort(), folder);
        gateway.expect("ready");
        phone.say("sms 6329 " + "Áé ÄÖÜ ñ ΔΦΓΛΩ €[]{} 0123456789 ".repeat(150));
        fax = Path.of(gateway.expect("fax").field("file"));
    }

    @AfterEach
    void stop() throws Exception {
        scenario.close();
    }

    @Test
    void libtiffReadsEachPageWithoutAWarning() throws Exception {
        Peer.TIFFINFO.require();
        String text = Peer.TIFFINFO.run("-D", fax.toString()).expectSuccess();
        List<String> lines = text.lines().map(String::strip).toList();
        for (String expected : List.of(
                "Image Width: 1728 Image Length: 2287",
                "Resolution: 204, 196 pixels/inch",
                "Compression Scheme: CCITT Group 3",
                "Photometric Interpretation: min-is-white",
                "FillOrder: lsb-to-msb",
                "Group 3 Options: (0 = 0x0)")) {
            assertEquals(2, lines.stream().filter(expected::equals).count(), expected + " twice in " + text);
        }
        assertTrue(lines.contains("Page Number: 1-2"), text);
        assertTrue(!text.contains("Warning"), text);
    }

    @Test
    void spanDspSendsAndReceivesEachPage() throws Exception {
        Path program = folder.resolve("spandsp_fax");
        Peer.Output compiled =
                Peer.C_COMPILER.run("-o", program.toString(), Peer.source("spandsp_fax.c"), "-lspandsp", "-ltiff");
        Peer.require(compiled.status() == 0, "SpanDSP and libtiff (libspandsp-dev, libtiff-dev): " + compiled.text());
        String text =
                Peer.run(new ProcessBuilder(program.toString(), fax.toString())).expectSuccess();
        // 204 by 196 dots an inch, in dots a metre; no bad row
        assertEquals("1728 2287 8031 7700 0\n".repeat(2), text);
        Peer.TIFFCMP.require();
        Peer.Output compared = Peer.TIFFCMP.run("-t", fax.toString(), fax + ".received");
        assertEquals(0, compared.status(), compared::text);
    }
}
