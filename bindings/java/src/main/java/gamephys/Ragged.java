package gamephys;

import java.util.List;

/** A list for each element of a batch: one after the other in values, from offsets.get(i) to offsets.get(i + 1). */
public record Ragged<T>(Batch<T> values, Batch<Integer> offsets) {
    public List<T> get(int index) {
        return values.subList(offsets.get(index), offsets.get(index + 1));
    }
}
