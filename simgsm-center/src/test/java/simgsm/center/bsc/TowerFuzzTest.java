package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Towers that answer anything at any time, valid messages with changed octets among it, do not take the exchange down. */
class TowerFuzzTest {
    private static final int MESSAGES = 4_000;
    private static final List<String> VALID = List.of(
            "0c1301881305123411 00",
            "08220120080000",
            "08220109080000",
            "0822010a080000",
            "0833 0120",
            "0833 0109",
            "0833 010a",
            "0206012002000b001205087000f110fffe33080910100050551000",
            "0206012002000b000d0627070333198105f412345678",
            "0302012002000b00030559 0a",
            "0302012002000b000b055908" + TowerStage.IMEI,
            "0302012002000b0002051b",
            "0302010902000b0003062900",
            "0302010902000b000306286f",
            "0302010a02000b0003062c00",
            "020601200203",
            "020501200203",
            "020801200203",
            "020901200200",
            "7e710109f80001f57f000001f34e20",
            "7e720109",
            "0824010a1a0101",
            "0827010a1100",
            "0823 0109 1a0101",
            "082801091b00190332320004000a00000b001206153232004f016000000000000000000000");

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void theExchangeServesAnotherTowerAfterwards(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        TowerStage stage = new TowerStage();
        List<TestTower> towers = new ArrayList<>(List.of(stage.west(), stage.east()));
        for (int i = 0; i < MESSAGES; i++) {
            TestTower tower = towers.get(random.nextInt(towers.size()));
            tower.up(changed(VALID.get(random.nextInt(VALID.size())).replace(" ", ""), random));
            tower.received.clear();
            if (random.nextInt(20) == 0) {
                stage.passMillis(random.nextInt(3_000));
            }
            if (random.nextInt(500) == 0) {
                tower.vanish();
                towers.set(towers.indexOf(tower), tower.name.equals("west") ? stage.west() : stage.east());
            }
        }
        towers.forEach(TestTower::vanish);
        stage.passMillis(60_000);

        TestTower after = stage.west();
        after.register("5550300", TowerStage.THIRD_IMEI);
        assertEquals(11L, stage.exchange.towers().get("west"));
    }

    private static String changed(String hex, SplittableRandom random) {
        byte[] octets = HexFormat.of().parseHex(hex);
        if (random.nextInt(4) == 0) {
            octets[random.nextInt(octets.length)] = (byte) random.nextInt(256);
        }
        return HexFormat.of()
                .formatHex(octets, 0, random.nextInt(30) == 0 ? random.nextInt(octets.length) : octets.length);
    }
}
