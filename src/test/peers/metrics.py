"""Reads metrics from a URL with the parser of prometheus_client; prints a line per sample: type, name, labels, value."""
import sys
import urllib.request

from prometheus_client.parser import text_string_to_metric_families

with urllib.request.urlopen(sys.argv[1], timeout=30) as answer:
    assert answer.headers["Content-Type"].startswith("text/plain; version=0.0.4"), answer.headers["Content-Type"]
    text = answer.read().decode("utf-8")
names = set()
for family in text_string_to_metric_families(text):
    assert family.documentation, family.name + " has no help"
    assert family.type in ("gauge", "counter"), family.name + " is " + family.type
    assert family.name not in names, family.name + " twice"
    names.add(family.name)
    for sample in family.samples:
        if family.type == "counter":
            assert sample.name.endswith("_total"), sample.name
        labels = ",".join(f"{key}={value}" for key, value in sorted(sample.labels.items()))
        print(family.type, sample.name, labels, int(sample.value), sep="\t")
