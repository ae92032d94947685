package simgsm.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;

/** Vectors published with other implementations, and of libosmogsm. */
class Comp128Test {
    @ParameterizedTest
    @CsvSource({
        "comp128v1, 68a641914bd5af66ea6144e1e7d1bef6, 75443bb0cac453ef0135e5b5bcaa98ee, b6859e44, d11f61652b53e800",
        "comp128v2, 68a641914bd5af66ea6144e1e7d1bef6, 75443bb0cac453ef0135e5b5bcaa98ee, ee14ee37, 84eaf6d508eea800",
        "comp128v3, 68a641914bd5af66ea6144e1e7d1bef6, 75443bb0cac453ef0135e5b5bcaa98ee, ee14ee37, 84eaf6d508eea863",
        "comp128v1, 00112233445566778899aabbccddeeff, 0123456789abcdef0123456789abcdef, 51e2bd26, 8395004b40e47800",
        "comp128v2, 00112233445566778899aabbccddeeff, 0123456789abcdef0123456789abcdef, 69e9e1af, 8bf83021c8767c00",
        "comp128v3, 00112233445566778899aabbccddeeff, 0123456789abcdef0123456789abcdef, 69e9e1af, 8bf83021c8767d54",
        "comp128v1, 465b5ce8b199b49faa5f0a2ee238a6bc, 23553cbe9637a89d218ae64dae47bf35, 27c443ca, e8d311d150017400",
        "comp128v2, 465b5ce8b199b49faa5f0a2ee238a6bc, 23553cbe9637a89d218ae64dae47bf35, f7e96810, 63760252cb4ac000",
        "comp128v3, 465b5ce8b199b49faa5f0a2ee238a6bc, 23553cbe9637a89d218ae64dae47bf35, f7e96810, 63760252cb4ac140"
    })
    void thePublishedVectorsComeOut(String algorithm, String k, String rand, String sres, String kc) {
        SimCard card = new SimCard(
                new Imsi("001010005550100"),
                new Msisdn("5550100"),
                OctetString.ofHex(k),
                CardAlgorithm.named(algorithm),
                Optional.empty(),
                Optional.empty());
        GsmVector vector = card.vector(OctetString.ofHex(rand));
        assertEquals(sres, vector.sres().toString());
        assertEquals(kc, vector.kc().toString());
    }
}
