package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** {@code --modem-audio soundcard} on PulseAudio, whose card is wired to a modem. */
@Tag("peer")
@Isolated("sound in real time through a server")
class ModemSoundCardTest {
    @Test
    void ordersAreHeardInTheInputAndAnsweredByTonesInTheOutput(@TempDir Path folder) throws Exception {
        for (Peer peer : List.of(Peer.PULSEAUDIO, Peer.PACTL, Peer.PAREC)) {
            peer.require();
        }
        Peer.Output output = Peer.PYTHON.run(Peer.source("soundcard.py"), folder.toString());
        assertEquals(
                List.of("**#*#90** executed", "**#**10** executed", "**#*#45** executed"),
                output.expectSuccess().lines().toList());
    }
}
